#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The guards of the house (tools/check-files, check-layers, check-data) refuse what each rule is there for, in every
# folder that it is there for, and nothing else.
# usage: guards.sh ROOT     in any folder; leaves nothing behind
set -uo pipefail
tools=$(readlink -f -- "$1")/tools
work=$(mktemp -d "${TMPDIR:-/tmp}/eyrie-guards-XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work" && git init -q . && mkdir src apps bench examples fuzz tests python || exit 2
failures=0

fail() { printf '%s\n' "$*" >&2; failures=$((failures + 1)); }
file() {  # PATH LINE...
  mkdir -p "$(dirname "$1")"
  printf '%s\n' '// SPDX-License-Identifier: MIT' "${@:2}" >"$1"
  git add "$1"
}
forget() { git rm -qf "$1"; }
refuses() {  # GUARD PATH LINE   the line stands in that file, as its second
  file "$2" "$3"
  local said
  if said=$("$tools/$1" . 2>&1); then
    fail "$1 lets $2 have: $3"
  elif [[ $said != *"$2:2:"* ]]; then
    fail "$1 does not say where, in $2: $3"$'\n'"$said"
  fi
  forget "$2"
}
lets() {  # GUARD PATH LINE
  file "$2" "$3"
  local said
  said=$("$tools/$1" . 2>&1) || fail "$1 refuses in $2: $3"$'\n'"$said"
  forget "$2"
}

for layer in ubf sim model team pilot driver; do
  for line in 'auto* leaf = dynamic_cast<Leaf*>(node);' 'std::unordered_map<int, int> seen;' 'std::unordered_set<int> seen;' \
    'auto now = std::chrono::steady_clock::now();' 'int n = std::rand();' '#include <random>' 'std::cout << n;' \
    'double y = 1 / std::sin(x);' 'double y = x*atan2(a, b);' 'float y = std::expf(x);' 'double y = (::tan(x));' \
    'const char* home = std::getenv("HOME");' 'fmt::print("{}", n);'; do
    refuses check-files "src/$layer/part.hpp" "$line"
  done
done
refuses check-files src/core/angles.cpp 'double y = std::log(x);'
lets check-files src/core/math.cpp 'double y = std::log(x);'
lets check-files src/team/part.cpp 'double y = math::sin(x);  // not std::sin(x), and no dynamic_cast'
lets check-files src/team/part_test.cpp 'double y = std::sin(x);'
lets check-files src/scenario/part.cpp 'std::unordered_map<int, int> seen;'
printf 'int a;\n' >bare.cpp && git add bare.cpp
[[ $("$tools/check-files" .) == *"bare.cpp:1: no SPDX line"* ]] || fail "a file without a license passes"
forget bare.cpp
mapfile -t long < <(seq 400)
file long.cpp "${long[@]}"
[[ $("$tools/check-files" .) == *"long.cpp:401:"* ]] || fail "a file of 401 lines passes"
forget long.cpp
lets check-files short.cpp "$(seq 399)"

refuses check-layers src/ubf/part.hpp '#include "sim/world.hpp"'
refuses check-layers src/sim/part.hpp '#include "ubf/tree.hpp"'
refuses check-layers src/driver/part.cpp '#include "pilot/state.hpp"'
refuses check-layers src/pilot/part.cpp '#include "driver/state.hpp"'
refuses check-layers src/team/part.cpp '#include "pilot/state.hpp"'
refuses check-layers src/model/part.cpp '#include "part_of_nothing.hpp"'
refuses check-layers src/model/part.cpp '#include <nlohmann/json.hpp>'
refuses check-layers src/page/part.cpp '#include <yaml.h>'
lets check-layers src/pilot/part.cpp '#include "team/rank.hpp"'
lets check-layers src/core/part.cpp '#include <yaml.h>'
file src/model/track/file.hpp '#include "model/fuse/part.hpp"'
file src/model/fuse/part.hpp '#include "model/columns.hpp"'
lets check-layers src/model/sensor/part.hpp '#include "model/track/file.hpp"'
refuses check-layers src/model/fuse/part.hpp '#include "model/track/part.hpp"'
file src/model/fuse/part.hpp '#include "model/sensor/part.hpp"'
refuses check-layers src/model/sensor/part.hpp '#include "model/track/file.hpp"'
forget src/model/track/file.hpp; forget src/model/fuse/part.hpp

for line in 'reach: 3 nmi' 'reach: 3 nmi  #' 'reach: 3 nmi  # m' 'reach: 3 nmi  # [judgement]' 'reach: 3 nmi  # guess' \
  '  value: [1, 2]' '  - 0.3  # 4 5 6'; do
  refuses check-data data/areas/part.yaml "$line"
done
for line in 'name: part' 'reach: 3 nmi  # Skolnik, sec. 2.5' 'mach: [0, 1]  # breakpoints'; do
  lets check-data data/areas/part.yaml "$line"
done
judged=$'reach: 3 nmi  # [judgement] as the M61\n' sourced=$'rate: 3 Hz  # Skolnik, sec. 2.5\n'
lets check-data data/areas/part.yaml "$judged$sourced$sourced"
file data/areas/part.yaml "$judged$judged$sourced$sourced"
said=$("$tools/check-data" . 2>&1) && fail "check-data lets half of the values be judgements"
[[ $said == *'2 of 4 values are [judgement]'* ]] || fail "check-data does not count: $said"
forget data/areas/part.yaml
mkdir -p data
said=$("$tools/check-data" . 2>&1) || fail "check-data refuses an empty folder: $said"
for kind in aircraft vehicles missiles guns radars; do
  key=entity_type
  [[ $kind == radars ]] && key=emitter
  file "data/$kind/part.yaml" 'name: part'
  said=$("$tools/check-data" . 2>&1) && fail "check-data lets data/$kind/part.yaml be without $key"
  [[ $said == "data/$kind/part.yaml:1: no $key: see docs/dis.md" ]] || fail "check-data does not say what is wrong: $said"
  forget "data/$kind/part.yaml"
  lets check-data "data/$kind/part.yaml" "$key: 1.2.225.1  # SISO-REF-010, by its number"
done
((failures == 0)) || { echo "$failures wrong" >&2; exit 1; }
