#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The script ./eyrie on machines where something is missing, with stand-ins for the tools it calls. Where the
# debrief page cannot be built (no npm, npm without a network, sources that do not bundle) it must say so
# once and fly all the same; what it needs besides it must name or install. What changed it must build, one at a
# time, and end whole when interrupted.
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
  local tool
  for tool in bash sh dirname readlink find cmp grep touch mkdir chmod cp rm cat mv nproc awk env flock head sed setsid sleep sort tail timeout; do
    ln -s "$(command -v "$tool")" "$work/tools/$tool"
  done
  tool cmake 'echo "configured: $*"; touch '"$work/build/build.ninja"
  tool ninja "$ninja"
  packages none
  run validate built >"$work/log"
  rm -r "$work/build/viewer"
}
# as if it compiled: it says what it was asked for, and makes it
ninja="for target; do :; done
echo \"built: \$*\"
cd '$work/build'
[ \$target != eyrie_package ] || { mkdir -p package/bin && echo >package/bin/eyrie; }
printf '#!/bin/sh\necho \"flown: \$*\"\n' >bin/eyrie
chmod +x bin/eyrie
touch .ninja_log"
tool() {  # NAME TEXT
  printf '#!/bin/sh\n%s\n' "$2" >"$work/tools/$1"
  chmod +x "$work/tools/$1"
}
run() {  # prints both streams, then the code
  (cd "$work" && env --default-signal=INT -i HOME="$work" PATH="$work/tools" EYRIE_BUILD_DIR="$work/build" EYRIE_PYTHON="$work/tools/python3" \
    EYRIE_NO_INSTALL="${EYRIE_NO_INSTALL-1}" timeout -k 1 100 setsid --wait bash project/eyrie "$@" 2>&1; echo "code $?")
}
await() {  # FILE: until something is in it
  local tries
  for ((tries = 0; tries < 2000; ++tries)); do [[ ! -s $1 ]] || return 0; sleep 0.02; done
  expect "$1" "empty after 40 s" ""
}
packages() {  # LACKING: the one that is not installed
  tool dpkg-query "for p; do [ \"\$p\" = '$1' ] || printf ' %s ' installed:\$p; done"
  tool apt-get 'echo "apt-get $*"'
}

page_said='fetching the packages*building the debrief page'

begin
expect "without npm" "$(run fly sweep)" \
  "eyrie: no debrief page: npm is missing (Debian's packages nodejs npm)"$'\n'"flown: fly sweep"$'\n'"code 0"
expect "the second time it is not tried again" "$(run fly sweep)" "flown: fly sweep"$'\n'"code 0"
expect "nor for what needs no page" "$(run validate sweep)" "flown: validate sweep"$'\n'"code 0"
touch -d '61 seconds ago' "$work/build/viewer/.failed"
expect "after a minute it is" "$(run debrief run)" "eyrie: no debrief page: npm is missing*flown: debrief run*code 0"
touch -d '61 seconds ago' "$work/build/viewer/.failed"
expect "then after two" "$(run fly)" "flown: fly"$'\n'"code 0"
echo 30 >"$work/build/viewer/.failed"
touch -d '59 minutes ago' "$work/build/viewer/.failed"
expect "at last after an hour" "$(run fly)" "flown: fly"$'\n'"code 0"
touch -d '61 minutes ago' "$work/build/viewer/.failed"
expect "and no later" "$(run fly)" "eyrie: no debrief page: npm is missing*"

begin
tool npm 'echo "npm ERR! code ENOTFOUND"; exit 1'
expect "without a network" "$(run fly)" "*npm could not fetch its packages (npm ERR! code ENOTFOUND)"$'\n'"flown: fly"$'\n'"code 0"
[[ -e $work/project/viewer/node_modules/.eyrie-lock ]] && expect "half fetched packages" "taken for whole" ""

fetches='mkdir -p node_modules && touch node_modules/.package-lock.json'
begin
tool npm "echo \"\$*\" >>'$work/asked'; [ \$(grep -c . '$work/asked') = 2 ] && $fetches && exit; echo 'npm ERR! Exit handler never called!'; exit 1"
tool node 'echo page >"$2/debrief.html"'
expect "npm that fails once" "$(run fly)" "eyrie: $page_said"$'\n'"flown: fly"$'\n'"code 0"
expect "no package runs a script of its own" "$(cat "$work/asked")" "ci --ignore-scripts *"$'\n'"ci --ignore-scripts *"

begin
tool npm 'mkdir -p node_modules; echo "npm ERR! Exit handler never called!"'
expect "npm that fails and does not say so" "$(run fly)" "*could not fetch its packages (npm ERR! Exit*flown: fly"$'\n'"code 0"

begin
tool npm "$fetches"
tool node 'echo "no such module"; exit 1'
expect "with broken sources" "$(run fly)" "*no such module*no debrief page: it could not be built"$'\n'"flown: fly"$'\n'"code 0"

begin
tool npm "$fetches"
tool node 'echo page >"$2/debrief.html"'
expect "with everything" "$(run fly)" "*$page_said"$'\n'"flown: fly"$'\n'"code 0"
expect "the page is there" "$(cat "$work/build/viewer/debrief.html")" page
expect "and is not built twice" "$(run fly)" "flown: fly"$'\n'"code 0"
rm "$work/build/viewer/debrief.html"
expect "but again when it is gone" "$(run fly)" "eyrie: building the debrief page"$'\n'"flown: fly"$'\n'"code 0"

begin
rm "$work/build/.program-stamp"
packages libyaml-dev
expect "a package that is missing" "$(run fly)" "*missing packages, not installed*"$'\n'"libyaml-dev"$'\n'"code 2"

building='*eyrie: building program*built: -C * eyrie*eyrie: built program in * s*'
begin
expect "a first build" "$(cat "$work/log")" "*eyrie: configuring$building"$'\n'"flown: validate built"$'\n'"code 0"
expect "nothing is built twice" "$(run validate sweep)" "flown: validate sweep"$'\n'"code 0"
echo 1 >"$work/project/src/new.cpp"
expect "what is new is built" "$(run validate sweep)" "$building"$'\n'"flown: validate sweep"$'\n'"code 0"
expect "once" "$(run validate sweep)" "flown: validate sweep"$'\n'"code 0"
echo 2 >"$work/project/src/new.cpp"
touch -d '2 hours ago' "$work/project/src/new.cpp"
tool ninja "[ ! project/src/new.cpp -nt build/.ninja_log ] || echo newer; $ninja"
expect "what changed into something older is built, and Ninja sees it" "$(run validate)" "*newer*"$'\n'"flown: validate"*
expect "once, too" "$(run validate sweep)" "flown: validate sweep"$'\n'"code 0"
echo 3 >"$work/project/src/new.cpp"
tool ninja "echo 44 >project/src/new.cpp; $ninja"
expect "what is saved during a build" "$(run validate)" "$building"$'\n'"flown: validate"*
tool ninja "[ ! project/src/new.cpp -nt build/.ninja_log ] || echo newer; $ninja"
expect "is built again, and Ninja sees it" "$(run validate)" "*newer*"$'\n'"flown: validate"*
expect "once, too" "$(run validate sweep)" "flown: validate sweep"$'\n'"code 0"
rm "$work/project/src/new.cpp"
expect "what is gone is built without it" "$(run validate)" "$building"$'\n'"flown: validate"*
rm "$work/build/bin/eyrie"
expect "a program that is gone is built again" "$(run validate)" "$building"$'\n'"flown: validate"*
tool ninja 'echo "error: src/new.cpp:1:1"; exit 1'
echo 3 >"$work/project/src/new.cpp"
touch "$work/build/.begun.left"
expect "a build that fails flies nothing" "$(run fly)" "*error: src/new.cpp:1:1"$'\n'"code 1"
expect "the next time neither" "$(run fly)" "*error: src/new.cpp:1:1"$'\n'"code 1"
expect "nothing is left of one that was interrupted" "$(cd "$work/build" && echo .begun*)" ".begun[*]"
tool ninja "$ninja"
expect "a plug-in needs the package" "$(run new behavior loop)" "*built: -C * eyrie_package*flown: new behavior loop"$'\n'"code 0"
expect "and then has it" "$(run validate)" "flown: validate"$'\n'"code 0"
rm "$work/build/bin/eyrie"
expect "a package left behind is no reason to build one" "$(run validate)" "*building program*flown: validate"$'\n'"code 0"
echo 5 >"$work/project/src/other.cpp"
expect "a plug-in that is used is" "$(run fly --plugin x.so)" "*built: -C * eyrie_package*flown: fly --plugin x.so"$'\n'"code 0"
expect "help builds nothing" "$(run help fly)" "flown: help fly"$'\n'"code 0"
mv "$work/project" "$work/moved"
ln -s moved "$work/project"
expect "a checkout that has moved flies" "$(run validate)" "flown: validate"$'\n'"code 0"
echo 4 >"$work/project/src/new.cpp"
expect "and when something changes is built anew" "$(run validate)" "*moved*building anew*configuring*built: *flown: validate"$'\n'"code 0"
expect "once as well" "$(run validate)" "flown: validate"$'\n'"code 0"

# the tests and the page are built under one lock
begin
tool npm "$fetches"
tool node 'echo page >"$2/debrief.html"'
tool ctest '[ "$1" != --help ] || { echo "  -R <regex>, --tests-regex <regex> = Run those."; exit; }
echo "tested: $*"'
tool ninja "sleep 0.2; $ninja"
expect "tests" "$(run test -R Break)" \
  "*built: -C * all*built tests*tested: --test-dir $work/build * -R Break"$'\n'"code 0"
expect "a wrong option builds nothing" "$(run test --repat)" "eyrie: ctest has no option '--repat'*"$'\n'"code 2"
expect "with a page" "$(cat "$work/build/viewer/debrief.html")" page

# help
begin
rm "$work/build/bin/eyrie"
tool ninja 'exit 1'
expect "help does not build" "$(run --help)" "The one script*./eyrie fly *not built yet*code 0"
expect "nor that of a subcommand" "$(run new --help)" "The one script*not built yet*code 0"
expect "nor that of the script itself" "$(run test --help)" "The one script*./eyrie fly *code 0"

# systems without apt
begin
rm "$work/tools/dpkg-query" "$work/build/bin/eyrie"
expect "another system that has everything" "$(run validate)" "$building"$'\n'"flown: validate"*
rm "$work/build/bin/eyrie" "$work/build/build.ninja"
tool cmake 'echo "no fmt"; exit 1'
for lack in fmt cmake; do
  [[ $lack == fmt ]] || rm "$work/tools/cmake"
  expect "another system without $lack" "$(run validate)" \
    "*install these by hand*compiler *g++*build *cmake ninja*libraries *libfmt-dev*tests *gtest*page *nodejs npm*cmake --preset release*code 2"
done
begin
rm "$work/build/bin/eyrie"
packages libfmt-dev
tool apt-get 'echo "E: Unable to locate package $*"; exit 100'
expect "apt that does not know a package" "$(EYRIE_NO_INSTALL='' run validate)" "*Unable to locate package*could not install: libfmt-dev*code 2"

# a stand-in that waits for a file gives up after a while
await='await() { i=0; while [ $i -lt 2000 ] && ! [ "$@" ]; do sleep 0.02; i=$((i + 1)); done; }; await'

# Ctrl-C reaches everybody on the terminal but what runs in the background
begin
rm "$work/build/bin/eyrie"
tool npm "echo \$\$ >'$work/npm'; exec sleep 300"
tool ninja "$await -s '$work/npm'; kill -INT 0; sleep 300"
expect "an interrupted build" "$(run fly)" "*building program*code 130"
expect "ends what ran beside it" "$(kill -0 "$(cat "$work/npm")" 2>&1 || echo gone)" "*gone"
tool ninja 'exit 1'
tool npm "echo \$\$ >'$work/npm'; touch '$work/begun'; exec sleep 300"
run fly >/dev/null
expect "and so does one that fails" "$(kill -0 "$(cat "$work/npm")" 2>&1 || echo gone)" "*gone"
expect "which is not npm's fault" "$(cd "$work/build/viewer" && echo .f*)" ".f[*]"

# two shells at once
begin
rm "$work/build/bin/eyrie"
tool ninja "echo begun >'$work/begun'; $await -e '$work/go'; $ninja"
run validate first >"$work/first" &
await "$work/begun"
run validate second >"$work/second" &
await "$work/second"
touch "$work/go"
wait
expect "the first of two builds" "$(cat "$work/first")" "$building"$'\n'"flown: validate first"*
expect "the second waits and need not" "$(cat "$work/second")" \
  "eyrie: another ./eyrie is building; waiting for it"$'\n'"flown: validate second"$'\n'"code 0"

# Python: makes a virtual environment, and is what stands in it
begin
mkdir "$work/project/python" && touch "$work/project/pyproject.toml"
tool python3 "case \$1\$2 in
  -mvenv) for to; do :; done; mkdir -p \$to/bin; cp $work/tools/python3 \$to/bin/python ;;
  -mpip) echo \"\$*\" >>'$work/asked'; [ ! -e '$work/broken' ] || { echo no compiler; exit 1; } ;;
  -*.toml) echo 'builder>=1' ;;
  *) echo \"python: \$*\" ;;
esac"
expect "python makes its package" "$(run python mine.py --help)" \
  "eyrie: building the Python package*eyrie: built the Python package in * s"$'\n'"python: mine.py --help"$'\n'"code 0"
expect "with what builds it" "$(cat "$work/asked")" "*install builder>=1"$'\n'"*--no-build-isolation $work/project"
expect "once" "$(run python mine.py --help)" "python: mine.py --help"$'\n'"code 0"
touch "$work/project/python/new.py" "$work/broken"
expect "again for a new source, and says why not" "$(run python -c 1)" \
  "*no compiler*the Python package could not be built*code 1"
rm "$work/broken"
expect "then once more" "$(run python -c 1)" "eyrie: building*python: -c 1"$'\n'"code 0"
expect "its help is at hand" "$(run help python)" "*./eyrie python *code 0"

exit $((failures > 0))
