#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# The options of the program: help, version, the list of all parameters, which
# is a scene itself, parameters and output directory from the command line.

source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

cp "$here/two_fibers.prm" .

succeeds() {
  check "the exit status is $status, not 0" [ "$status" -eq 0 ]
  check "something is on stderr" [ ! -s "$captured/err" ]
}

# Information

for option in --help -h; do
  run "$option"
  succeeds
  check "no usage" on_stdout '^Usage: setae'
  for name in --set --output --calibrate --print-parameters --version --help; do
    check "$name is not explained" on_stdout "^ +$name"
  done
done

run --version
succeeds
check "no version" on_stdout '^setae [0-9]+\.[0-9]+\.[0-9]+ \([0-9a-z]+\), deal\.II 9'
check "more than a line" [ "$(wc -l <"$captured/out")" -eq 1 ]

# Every parameter has a documentation: a comment right before it that says more
# than its default.

run --print-parameters
succeeds
cp "$captured/out" all.prm
n_parameters=$(grep -c '^ *set ' all.prm)
check "only $n_parameters parameters" [ "$n_parameters" -ge 50 ]
check "undocumented: $(awk '
    /^ *#/  { comment = 1; next }
    /^ *set / { if (!comment) print $0 }
            { comment = 0 }' all.prm)" \
  awk '/^ *#/  { comment = 1; next }
       /^ *set / && !comment { bad = 1 }
               { comment = 0 }
       END     { exit bad }' all.prm
for section in NAME fibers supports loads interactions "load stepping" \
  dynamics newton output; do
  check "no section '$section'" on_stdout "^ *subsection $section\$"
done

# It is a scene: only what has no default is left to give.

run all.prm
one_line_with "'interactions/NAME/prefactors'"
given=(--set "interactions/NAME/equilibrium gap=1e-3"
  --set "interactions/NAME/force minimum=-1"
  --set "interactions/NAME/cutoff=0.1")
run all.prm "${given[@]}"
one_line_with "'supports/names'" "'NAME' is not"
run all.prm "${given[@]}" --set "supports/NAME/displacement=0; 0; 0" \
  --set "supports/NAME/tangent=0; 0; 0" --output defaults
succeeds
check "the defaults do not run to the end" grep -qE '^ *[0-9]+ 1\.0+e\+00' \
  defaults/statistics.txt

# Prefactors fitted to the exact force: the law of section and beam is exact for
# parallel fibers as the gap closes.

before=$(listing)
run --calibrate 1e-8 two_fibers.prm
succeeds
check "no factor of one for m = 6 and 12" [ "$(
  grep -cE '^ +(6|12) +(1\.0000|0\.9999)[0-9]{2} ' "$captured/out"
)" -eq 2 ]
check "no table of errors" on_stdout '^ +1\.000e-07( +-?[0-9.]+){4}$'
run --calibrate 1e-3,90 two_fibers.prm
succeeds
check "not at an angle" on_stdout 'crossing at 90 degrees'
for wrong in 0 -1 1e-3,91 1e-3,1,1 near; do
  run --calibrate "$wrong" two_fibers.prm
  one_line_with "--calibrate" "'$wrong'"
done
run --calibrate 1e-3
one_line_with "no scene"
check "something was written" [ "$before" = "$(listing)" ]

# A run

run two_fibers.prm
succeeds
check "no results in the directory of the scene" [ -s results/statistics.txt ]
check "no fields" [ -s results/fibers.pvd ]
check "no cloud of forces" [ -s results/interaction.pvd ]
# The cells of a line have ends and a type, or no program can read the file.
for array in connectivity offsets types; do
  check "no $array in the fields" grep -q '[^ ]' <(
    grep -A1 "Name=\"$array\"" results/fibers_00000.vtu | tail -n +2)
done
check "no steps on the screen" on_stdout '^step +1 '

before=$(listing)
run two_fibers.prm --output elsewhere/below
succeeds
check "no results in the given directory" [ -s elsewhere/below/statistics.txt ]
rm -r elsewhere
check "something else was written" [ "$before" = "$(listing)" ]

run two_fibers.prm --output repeated/first --set "fibers/right/cells=5" \
  --set "load stepping/end time = 2e-5" --set "newton/log iterations=true"
succeeds
check "iterations are not logged" on_stdout 'iteration +1'
check "9 cells are not used" on_stdout '\b9 cells'
check "the last value of --set is not used" \
  grep -qE 'set end time += 2e-5' repeated/first/parameters.prm
run repeated/first/parameters.prm --output repeated/second
succeeds
without_clock() { sed '/wall time/d; s/ [^ ]* *$//' "$1"; }
for run in first second; do
  without_clock "repeated/$run/statistics.txt" >"repeated/$run.txt"
done
check "a run with the written parameters differs" \
  diff repeated/first.txt repeated/second.txt

run two_fibers.prm --set "output/directory="
succeeds
check "no results in the default directory" [ -s output-two_fibers/statistics.txt ]

# Results of an earlier run do not mix with those of a later one.
touch results/notes.txt
run two_fibers.prm --set "output/fields=false"
succeeds
check "fields of an earlier run are left" [ -z "$(ls results | grep -E 'vtu|pvd')" ]
check "a file of the user's is gone" [ -e results/notes.txt ]

finish
