#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# prm/run runs the scene it is asked for and no other; prm/plot draws what changes in
# every shipped scene, and does not fail a run.

source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

export MPLCONFIGDIR=$captured/matplotlib
prm=$here/../../prm
plot=(/usr/bin/python3 "$prm/plot")

# prm/run in a copy of the tree that takes the program as it is.
mkdir -p tree/.ci tree/build/release
cp -r "$prm" tree/prm
sed '/^need()/,/^}/d; /^build_targets()/,/^}/d' "$here/../../.ci/setup.sh" \
  >tree/.ci/setup.sh
echo 'need() { :; }; build_targets() { :; }' >>tree/.ci/setup.sh
ln -s "$setae" tree/build/release/setae

# script ARGUMENT...: call prm/run; leaves $status.
script() {
  call="prm/run $*"
  timeout 100 bash tree/prm/run "$@" >"$captured/out" 2>"$captured/err" </dev/null
  status=$?
}
runs() {
  script "$@"
  check "the exit status is $status, not 0" [ "$status" -eq 0 ]
}

# A scene of one's own that has the name of a shipped one.
mkdir -p some/where
sed 's/^set title.*//; 1i set title = a scene of my own' "$here/two_fibers.prm" \
  >some/where/elastica.prm
runs some/where/elastica.prm --output mine
check "prm/run runs another scene" on_stdout '^a scene of my own$'
check "no plot" [ -s mine/curve.png ]
runs --output shipped --set output/fields=false elastica
check "prm/run does not run the shipped scene" on_stdout '^Elastica'
runs elastica.prm --output shipped
check "prm/run does not run the shipped scene" on_stdout '^Elastica'
cp some/where/elastica.prm .
runs elastica.prm --output mine
check "prm/run runs the shipped scene instead of a file" \
  on_stdout '^a scene of my own$'
for wrong in nowhere/elastica.prm nowhere/elastica some/where/elastica prm/elastic \
  ./snap.prm "$here/expect.sh" some/where; do
  script "$wrong"
  check "the exit status is $status, not 1" [ "$status" -eq 1 ]
  check "not one line on stderr" [ "$(n_lines_on_stderr)" -eq 1 ]
  check "the scenes are not listed" on_stderr "elastica peeling"
done

# A run that fails, and a plot that fails.
script some/where/elastica.prm --set "fibers/left/radius=-1"
check "a run that fails succeeds" [ "$status" -eq 1 ]
echo 'raise SystemExit("no plot today")' >tree/prm/plot
runs some/where/elastica.prm --output mine
check "no notice" on_stdout 'no plot; the results are in mine'
check "the plot of the run before is left" [ ! -e mine/curve.png ]

# What is drawn of each kind of scene: titles and curves of its axes.
if ! "${plot[@]}" --help >/dev/null 2>&1; then
  echo "matplotlib is missing: the plots are not tested."
  finish
fi
draws() {
  local folder=$1 name=$2 title=$3
  call="prm/plot $folder $name"
  "${plot[@]}" "$folder" ${name:+"$name"} >"$captured/out" 2>"$captured/err"
  status=$?
  check "the plot fails" [ "$status" -eq 0 ]
  check "no picture" [ "$(head -c 4 "$folder/curve.png" | tail -c 3)" = PNG ]
  /usr/bin/python3 - "$prm/plot" "$folder" ${name:+"$name"} >"$captured/drawn" <<'PYTHON'
import runpy, sys
from matplotlib import pyplot
sys.argv = sys.argv[1:]
runpy.run_path(sys.argv[0])
for axes in pyplot.gcf().axes:
    curves = ", ".join(line.get_label() for line in axes.lines)
    print(f"{axes.get_ylabel()} over {axes.get_xlabel()}: {curves}")
PYTHON
  check "it does not show '$title'" grep -qF -e "$title" "$captured/drawn"
}
short() {
  local scene=$1
  shift
  run "$prm/$scene.prm" --output "$scene" --set output/fields=false "$@"
  check "$scene fails" [ "$status" -eq 0 ]
}
short elastica
draws elastica "" "displacement [length] over time t [time]: point displacement x of 'tip', point displacement y of 'tip'"
draws elastica tip "point displacement y of 'tip'"
short cantilever_moment
draws cantilever_moment "" "point displacement x of 'tip', point displacement y of 'tip'"
short charged_brush --set "fibers/brush/copies=2, 2" --set "load stepping/end time=0.005"
draws charged_brush "" "energy [energy] over time t [time]: strain energy, interaction energy"
short charged_pair --set "load stepping/end time=0.3"
draws charged_pair "" "point displacement x of 'midpoint', point displacement y of 'midpoint'"
short beam_on_arc --set "load stepping/end time=1.2"
draws beam_on_arc "" "reaction [force] over time t [time]: reaction"
for scene in peeling peeling_ssip peeling_issip; do
  # The points of the last one would be too many for a test.
  short "$scene" --set "load stepping/end time=3e-5" \
    --set "interactions/adhesion/integration segments=4"
  draws "$scene" "" "reaction x of 'right' [force] over displacement x of 'right' [length]"
done
draws peeling right "reaction x of 'right' [force] over displacement x of 'right'"
short snap --set "dynamics/time step=2e-4" --set "dynamics/end time=1e-3" \
  --set "interactions/coulomb/gauss points=3"
draws snap "" "energy [energy] over time t [time]: total energy, energy balance"
for scene in "$prm"/*.prm; do
  check "$scene is not drawn" [ -s "$(basename "$scene" .prm)/curve.png" ]
done

# What cannot be drawn is told in one line.
"${plot[@]}" nowhere >"$captured/out" 2>"$captured/err"
check "a folder without results is drawn" [ $? -eq 1 ]
check "not one line on stderr" [ "$(n_lines_on_stderr)" -eq 1 ]
"${plot[@]}" peeling nobody >"$captured/out" 2>"$captured/err"
check "a support that is not there is drawn" [ $? -eq 1 ]
check "its name is not told" on_stderr "'nobody'"

finish
