#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Python package: installed by pip in a virtual environment of its own, tested by pytest away from the sources,
# its types checked by mypy. Installed again only if a source changed.
# usage: package.sh ROOT BUILD WERROR     BUILD-python is where it is built, with the environment in it; EYRIE_PROGRAM is the program to compare with
set -euo pipefail
root=$(readlink -f -- "$1") work=$2-python werror=$3
venv=$work/venv
mkdir -p "$work"
exec {lock}>"$work/.lock"
flock "$lock"

now=$(cd "$root" && { /usr/bin/python3 --version; find src cmake data scenarios python CMakeLists.txt pyproject.toml -type f -printf '%p %T@ %s\n'; } | LC_ALL=C sort)
if [[ ! -e $work/.installed || $(<"$work/.installed") != "$now" ]]; then
  pip=("$venv/bin/python" -m pip --disable-pip-version-check --quiet install)
  [[ -e $work/.installed ]] || /usr/bin/python3 -m venv --clear "$venv"
  "${pip[@]}" 'scikit-build-core>=1.0,<2' 'nanobind>=3.1,<4'
  CXX=${CXX:-g++} CMAKE_BUILD_PARALLEL_LEVEL=$(nproc) "${pip[@]}" --no-build-isolation --config-settings=build-dir="$work" \
    --config-settings=cmake.define.EYRIE_WERROR="$werror" "${root}[test]"
  printf '%s\n' "$now" >"$work/.installed"
fi

export EYRIE_PROGRAM_HOME=$root
unset EYRIE_HOME
cd "$work"
"$venv/bin/python" -m mypy --config-file "$root/pyproject.toml" --no-error-summary -p eyrie
"$venv/bin/python" -m mypy --config-file "$root/pyproject.toml" --no-error-summary "$root/python/tests"
exec "$venv/bin/python" -P -m pytest -c "$root/pyproject.toml" --rootdir "$root/python/tests" --import-mode=importlib "$root/python/tests"
