#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The script ./eyrie on machines where something is missing, with stand-ins for the tools it calls. Where the
# debrief page cannot be built (no npm, npm without a network, sources that do not bundle) it must say so
# once and fly all the same; what it needs besides it must name or install.
# usage: setup.sh SCRIPT     in any folder; leaves nothing behind
set -uo pipefail
script=$(readlink -f -- "$1")
work=$(mktemp -d "${TMPDIR:-/tmp}/eyrie-script-XXXXXX")
trap 'rm -rf "$work"' EXIT
failures=0

expect() {  # WHAT ACTUAL WANTED(a pattern)
  # shellcheck disable=SC2053
  [[ $2 == $3 ]] && return
  printf '%s: got\n%s\nand not\n%s\n' "$1" "$2" "$3" >&2
  failures=$((failures + 1))
}

# a project that is built, but for its page
begin() {
  rm -rf "${work:?}"/*
  mkdir -p "$work"/project/{src,apps,cmake,viewer} "$work"/build/bin "$work"/tools
  cp "$script" "$work/project/eyrie"
  touch "$work"/project/{CMakeLists.txt,CMakePresets.json}
  echo '{}' >"$work/project/viewer/package-lock.json"
  printf '#!/bin/sh\necho "flown: $*"\n' >"$work/build/bin/eyrie"
  chmod +x "$work/build/bin/eyrie"
  touch "$work/build/.program-stamp"
  local tool
  for tool in bash sh dirname readlink find cmp grep touch mkdir cp rm cat mv mktemp nproc awk env; do
    ln -s "$(command -v "$tool")" "$work/tools/$tool"
  done
}
tool() {  # NAME TEXT
  printf '#!/bin/sh\n%s\n' "$2" >"$work/tools/$1"
  chmod +x "$work/tools/$1"
}
run() {  # prints both streams, then the code
  (cd "$work" && env -i HOME="$work" PATH="$work/tools" EYRIE_NO_INSTALL=1 EYRIE_BUILD_DIR="$work/build" \
    bash project/eyrie "$@" 2>&1; echo "code $?")
}
packages() {  # LACKING: the one that is not installed
  tool dpkg-query "for p; do :; done; [ \"\$p\" = '$1' ] || echo installed"
}

begin
expect "without npm" "$(run fly sweep)" \
  "eyrie: no debrief page: npm is missing (Debian's packages nodejs and npm)"$'\n'"flown: fly sweep"$'\n'"code 0"
expect "the second time it is not tried again" "$(run fly sweep)" "flown: fly sweep"$'\n'"code 0"
expect "nor for what needs no page" "$(run validate sweep)" "flown: validate sweep"$'\n'"code 0"
touch -d '2 hours ago' "$work/build/viewer/.failed"
expect "after an hour it is" "$(run debrief run)" "eyrie: no debrief page: npm is missing*flown: debrief run*code 0"

begin
tool npm 'echo "npm ERR! code ENOTFOUND"; exit 1'
expect "without a network" "$(run fly)" "*npm could not fetch its packages (npm ERR! code ENOTFOUND)"$'\n'"flown: fly"$'\n'"code 0"
[[ -e $work/project/viewer/node_modules/.eyrie-lock ]] && expect "half fetched packages" "taken for whole" ""

begin
tool npm 'mkdir -p node_modules'
tool node 'echo "no such module"; exit 1'
expect "with broken sources" "$(run fly)" "*no such module*no debrief page: it could not be built"$'\n'"flown: fly"$'\n'"code 0"

begin
tool npm 'mkdir -p node_modules'
tool node 'echo page >"$2"'
expect "with everything" "$(run fly)" "*fetching*building the debrief page"$'\n'"flown: fly"$'\n'"code 0"
expect "the page is there" "$(cat "$work/build/viewer/debrief.html")" page
expect "and is not built twice" "$(run fly)" "flown: fly"$'\n'"code 0"

begin
packages libyaml-dev
rm "$work/build/.program-stamp"
expect "a package that is missing" "$(run fly)" "*missing packages, not installed*"$'\n'"libyaml-dev"$'\n'"code 2"
packages none
touch "$work/build/build.ninja"
tool cmake 'echo "configured: $*"'
tool ninja 'echo "built: $*"'
expect "a first build" "$(run validate sweep)" "*building program*built: -C $work/build -j * eyrie*flown: validate sweep"$'\n'"code 0"
expect "nothing is built twice" "$(run validate sweep)" "flown: validate sweep"$'\n'"code 0"
touch -d '1 minute' "$work/project/src/new.cpp"
expect "what changed is built" "$(run validate sweep)" "*building program*flown: validate sweep"$'\n'"code 0"
expect "a plug-in needs the package" "$(run new behavior loop)" "*built: -C $work/build -j * eyrie_package*flown: new behavior loop"$'\n'"code 0"
tool ninja 'echo "error: src/new.cpp:1:1"; exit 1'
touch -d '2 minutes' "$work/project/src/new.cpp"
expect "a build that fails flies nothing" "$(run fly)" "*error: src/new.cpp:1:1"$'\n'"code 1"

exit $((failures > 0))
