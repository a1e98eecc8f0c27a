#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# Whatever is wrong in the input ends the program with status 1 and exactly one
# line, which names the parameter, its value and what is allowed, before
# anything is written: results of an earlier run stay as they are.

source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

cp "$here/two_fibers.prm" .
cat >branched.vtk <<'END'
# vtk DataFile Version 3.0
a star of three lines
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 4 double
0 0 0  1 0 0  0 1 0  0 -1 0
CELLS 3 9
2 0 1  2 0 2  2 0 3
CELL_TYPES 3
3 3 3
END
echo "no mesh" >no_mesh.msh
sed -e 's/^CELLS 3 9/CELLS 2 6/' -e 's/^2 0 1  2 0 2  2 0 3/2 1 0  2 1 3/' \
  -e 's/^CELL_TYPES 3/CELL_TYPES 2/' -e 's/^3 3 3/3 3/' \
  -e 's/^0 0 0  1 0 0  0 1 0  0 -1 0/0 0 0  1 0 0  0 1 0  1 1 0/' \
  branched.vtk >bent.vtk

# The output directory of the scene, with results.
mkdir -p results
echo "an earlier result" >results/statistics.txt

# rejects ARGUMENTS... -- FRAGMENTS...
rejects() {
  local arguments=() before
  while [[ $1 != -- ]]; do
    arguments+=("$1")
    shift
  done
  shift
  before=$(listing)
  run "${arguments[@]}"
  one_line_with "$@"
  check "something is on stdout" [ ! -s "$captured/out" ]
  check "something was written" [ "$before" = "$(listing)" ]
}

# The scene is right as long as nothing is changed in it.
run two_fibers.prm --output good
check "the unchanged scene fails" [ "$status" -eq 0 ]
check "the unchanged scene writes to stderr" [ ! -s "$captured/err" ]
check "the unchanged scene writes no results" [ -s good/statistics.txt ]

# A parameter, its bad value and what is allowed, as it stands in the message.
while IFS='|' read -r parameter value allowed; do
  [[ -z $parameter ]] ||
    rejects two_fibers.prm --set "$parameter=$value" -- \
      "'$parameter'" "'$value'" "$allowed"
done <<'END'
coordinates||at least one of x, y, z
coordinates|x, w|x|y|z
constants|l|a list 'name = value, ...'
constants|s = 3, g_eq = 1|other than s, t, i, j, k, pi
fibers/left/radius|-1|Double 0
fibers/left/radius|0|positive
fibers/left/radius|thin|Double 0
fibers/left/radius|nan|Double 0
fibers/left/length|0|positive
fibers/left/youngs modulus|0|positive
fibers/left/poisson ratio|1|at most 0.5
fibers/left/number density|-1|Double 0
fibers/left/cells|0|1...
fibers/left/cells|2.5|Integer
fibers/left/copies|2, 0|1...
fibers/left/copies|1, 1, 1, 2|length 1...3
fibers/left/beam|rope|torsion-free Kirchhoff-Love
fibers/left/centerline|0; s|three formulas
fibers/left/centerline|0; 1; 0|a curve with a tangent at every s
fibers/left/centerline|0; s^2; 0|a curve with a tangent at every s
fibers/left/mesh file|none.msh|a file that exists
fibers/left/mesh file|no_mesh.msh|a mesh of lines that can be read: The string <no> is not recognized
fibers/left/mesh file|branched.vtk|without branches, but 3 lines meet at node 0 at (0, 0, 0)
fibers/left/mesh file|bent.vtk|without kinks, but at node 1 at (1, 0, 0) it turns by 90 degrees
fibers/left/largest kink|-1|Double 0...180
fibers/left/cells|l/2|Integer
fibers/left/radius|-l|Double 0
fibers/left/radius|0,02|Double 0
fibers/left/radius|R|or a formula
fibers/left/radius|i - 1|Double 0
fibers/left/copies|1 + i|the same for all
fibers/left/centerline|0; if(s < 2.5, s, 2.5); if(s < 2.5, 0, s - 2.5)|turns by 90 degrees at s = 2.5, (0, 2.5, 0)
fibers/left/centerline|1e12; s; 0|nearer to the origin
fibers/left/centerline|-sin(pi*s/5); sin(2*pi*s/5); 0|comes back to its start (-0, 0, 0) turned by
constants|l = 0,5, g_eq = 1e-3|'name = value, ...'
constants|l = 5, l = 6, g_eq = 1e-3|has 'l' twice
supports/held/copies|i == 1|holds for at least one
loads/weight/copies|i > 0|holds for at least one
supports/held/fibers|nobody|all, left, right
supports/held/at|middle|an arc length
supports/held/at|1.3|the nearest one is at 1.25
supports/held/displacement|0; 0|three times 'free' or a formula
supports/held/tangent|0; 0|three times 'free' or a formula
supports/held/tangent|0; -1; free|keeps the length 1, but it has the length 0 at t = 0
supports/held/tangent|0.5; 0; 0|it has the length 1.11803 at t = 0; 'tangent direction' leaves
supports/held/tangent|free; 0.5; 0|the components that are given have the length 1.5 at t = 0
supports/held/tangent direction|along|three formulas
supports/held/tangent direction|0; 0; 0|a vector with a direction at every time, but not at t = 0
supports/held/tangent direction|0; 1; 1|in the plane of the active coordinates
loads/weight/fibers|nobody|all, left, right
loads/weight/at|5.1|at least 0 and at most the length 5
loads/weight/force|0; 0|three formulas
interactions/adhesion/law|gravity|disk-disk
interactions/adhesion/source|nobody|all, left, right
interactions/adhesion/target|nobody|all, left, right
interactions/adhesion/two half passes|maybe|Bool
interactions/adhesion/integration rule|simpson|gauss|midpoint
interactions/adhesion/frame|target|averaged|source
interactions/adhesion/frame|source|left out with the law 'disk-cylinder'
interactions/adhesion/cutoff of|stiffness|energy|forces
interactions/adhesion/cutoff of|forces|left out with the law 'disk-cylinder'
interactions/adhesion/interaction moments|false|left out with the law 'disk-cylinder'
interactions/adhesion/prefactors|-1, 1|'equilibrium gap' and 'force minimum'
interactions/adhesion/exponents|6, 10|6, 12 with an equilibrium gap
interactions/adhesion/distribution|edge|volume|surface
interactions/adhesion/distribution|surface|volume for the law 'disk-cylinder'
interactions/adhesion/strength|t+|formula
interactions/adhesion/penalty|-1|Double
interactions/adhesion/penalty|1|0 but for the law 'penalty-contact'
interactions/adhesion/target ends|open|by law|clamped|finite
interactions/adhesion/equilibrium gap|0|positive
interactions/adhesion/force minimum|1|Double
interactions/adhesion/force minimum|0|negative
interactions/adhesion/hamaker constant|much|Double
interactions/adhesion/far field tolerance|0.001|only 'monopole' has a far field
interactions/adhesion/far field tolerance|1|Double 0
interactions/adhesion/integration tolerance|1|Double 0
interactions/adhesion/integration tolerance|1e-15|from 1e-14
interactions/adhesion/cutoff|0|positive
interactions/adhesion/switch width|2|Double 0...1
interactions/adhesion/regularization gap|0.1|below the gap from which on the cutoff
load stepping/end time|0|positive
load stepping/first step|0|positive
load stepping/smallest step|1|at most the first step; how finely an instability is located is 'instability resolution'
load stepping/instability resolution|0|positive
load stepping/largest step|-1|positive
load stepping/largest step|0|positive at every time, but is 0 at t = 0
load stepping/largest step|1e-13|at least 'load stepping/smallest step'
load stepping/growth|0.5|Double 1
fibers/left/density|-1|Double 0
dynamics/integrator|leapfrog|none|generalized-alpha|energy-conserving|IDA
dynamics/end time|-1|Double 0
dynamics/time step|-1|Double 0
dynamics/tolerance|-1|Double 0
dynamics/energy tolerance|-1|Double 0
dynamics/largest energy gain|-1|Double 0
dynamics/damping|-1|Double 0
dynamics/rho infinity|1.1|0...1
dynamics/rho infinity|-0.1|Double 0...1
dynamics/largest order|6|1...5
newton/iterations|0|1...
newton/relative residual tolerance|0|positive
newton/relative increment tolerance|0|positive
newton/residual tolerance|-1|Double 0
newton/increment tolerance|-1|Double 0
newton/linear solver|Umfpack|Amesos_Klu
newton/log iterations|2|Bool
output/interval|-1|Double 0
output/subdivisions|0|1...
END

# One of several formulas or names is wrong: the message shows that one.
while IFS='|' read -r parameter value part allowed; do
  rejects two_fibers.prm --set "$parameter=$value" -- \
    "'$parameter'" "'$part'" "$allowed"
done <<'END'
fibers/left/centerline|0,04*s; s; 0|0,04*s|a comma outside a function call
loads/weight/force|0; if(t=0.5, 1, 2); 0|if(t=0.5, 1, 2)|'==' compares
loads/weight/force|0; 1/(t - t); 0|1/(t - t)|is inf at s = 
fibers/left/centerline|0; 1e7 + s; 0|0; 1e+07; 0|of 'interactions/adhesion/equilibrium gap'
supports/held/displacement|0; 0,1*t; free|0,1*t|a comma outside a function call
END
while IFS='|' read -r parameter value shown allowed; do
  [[ -z $parameter ]] ||
    rejects two_fibers.prm --set "$parameter=$value" -- \
      "'$parameter'" "'$shown'" "$allowed"
done <<'END'
constants|g_eq = 1, R = 2*q|2*q|g_eq, pi
constants|2x = 1, g_eq = 1|2x = 1, g_eq = 1|has '2x = 1'
fibers/left/centerline|0; s + q; 0|s + q|s, g_eq, i, j, k, l, pi
fibers/names|left, all|all|different names
supports/names|held, held|held|different names
fibers/left/centerline|0; s; sin(|sin(|a formula
fibers/left/centerline|0; log(-1 - s); 0|log(-1 - s)|finite
supports/held/displacement|0; q*t; 0|q*t|t, g_eq, i, j, k, l, pi
supports/held/displacement|1/t; 0; free|1/t|finite
loads/weight/force|0; 0; q*s|q*s|s,t, g_eq, i, j, k, l, pi
load stepping/largest step|if(t < q, 1, 2)|if(t < q, 1, 2)|t, g_eq, l, pi
END

# Parameters that do not fit each other.
overlap=("Fibers overlap" "'left'" "'right'" "must be positive")
rejects two_fibers.prm --set "fibers/right/centerline=0.039; s; 0" -- \
  "${overlap[@]}" -0.001
rejects two_fibers.prm --set "fibers/right/centerline=0; s; 0" -- \
  "${overlap[@]}" -0.04
rejects two_fibers.prm \
  --set "interactions/adhesion/law=disk-disk" \
  --set "fibers/right/centerline=0.039; s; 0" -- "${overlap[@]}" -0.001
rejects two_fibers.prm --set "supports/pulled/fibers=left" \
  --set "supports/held/at=start" --set "supports/pulled/at=end" -- \
  "'supports/names'" "'held, pulled'" "'right' is not"
rejects two_fibers.prm --set "supports/pulled/fibers=all" -- \
  "'supports/pulled/displacement'" "'t; 0; free'" "free where" "'held'"
rejects two_fibers.prm --set "fibers/right/radius=0.03" -- \
  "'interactions/adhesion/force minimum'" "-0.1" "'prefactors'"
rejects two_fibers.prm --set "coordinates=x, y, z" \
  --set "fibers/left/centerline=sin(s); cos(s); 0" -- \
  "'fibers/left/centerline'" "curved" "straight"
rejects two_fibers.prm --set "fibers/left/centerline=0; cos(s); sin(s)" -- \
  "'fibers/left/centerline'" "curved out of the plane" "in the plane"
rejects two_fibers.prm --set "supports/held/tangent direction=initial" \
  --set "supports/held/tangent=0; free; free" -- \
  "'supports/held/tangent direction'" "'initial'" "'free' where the support" \
  "'held' holds a component"

# What says how strong an interaction is: one way, not two.
adhesion=interactions/adhesion
rejects two_fibers.prm --set "$adhesion/hamaker constant=1e-3" -- \
  "'$adhesion/force minimum'" "'-0.1'" "0 with 'hamaker constant'"
rejects two_fibers.prm --set "$adhesion/hamaker constant=-1e-3" \
  --set "$adhesion/force minimum=0" -- "'$adhesion/hamaker constant'" \
  "'-0.001'" "positive, an attraction, with an equilibrium gap"
rejects two_fibers.prm --set "$adhesion/hamaker constant=1e-3" \
  --set "$adhesion/force minimum=0" --set "$adhesion/equilibrium gap=0" -- \
  "'$adhesion/exponents'" "'6, 12'" "6 with 'hamaker constant'"
rejects two_fibers.prm --set "$adhesion/hamaker constant=1e-3" \
  --set "$adhesion/force minimum=0" --set "fibers/right/radius=0.03" -- \
  "'$adhesion/equilibrium gap'" "'0.001'" "'prefactors'"
for law in monopole quadrupole penalty-contact; do
  rejects two_fibers.prm --set "$adhesion/law=$law" -- \
    "'$adhesion/equilibrium gap'" "'0.001'" "left out for the law '$law'"
done

# Which ends a law can have.
rejects two_fibers.prm --set "$adhesion/law=penalty-contact" \
  --set "$adhesion/equilibrium gap=0" --set "$adhesion/force minimum=0" \
  --set "$adhesion/penalty=1" --set "$adhesion/cutoff=0" \
  --set "$adhesion/target ends=finite" -- "'$adhesion/target ends'" \
  "'finite'" "whose ends are round; those of a potential are flat"
rejects two_fibers.prm --set "$adhesion/law=disk-disk" \
  --set "$adhesion/target ends=clamped" -- "'$adhesion/target ends'" \
  "'clamped'" "whose target is integrated over"

with_prefactors() {
  rejects two_fibers.prm --set "interactions/adhesion/equilibrium gap=0" \
    --set "interactions/adhesion/force minimum=0" \
    --set "interactions/adhesion/prefactors=$1" \
    --set "interactions/adhesion/exponents=$2" \
    --set "interactions/adhesion/law=$3" -- "${@:4}"
}
with_prefactors "1" 1 monopole "'interactions/adhesion/regularization gap'" \
  "'monopole'"
with_prefactors "1" 1 penalty-contact "'interactions/adhesion/penalty'" \
  "positive"
with_prefactors "" "6, 12" disk-disk "'interactions/adhesion/prefactors'" "''" \
  "'equilibrium gap' and 'force minimum'"
with_prefactors "-1" "6, 12" disk-disk "'interactions/adhesion/prefactors'" \
  "'-1'" "as many as there are exponents, 2"
with_prefactors "-1" 3 disk-disk "'interactions/adhesion/exponents'" "'3'" \
  "at least 4 for the law 'disk-disk'"
with_prefactors "-1" 5 disk-cylinder "'interactions/adhesion/exponents'" \
  "'5'" "at least 6 for the law 'disk-cylinder'"

# Motions: with inertia there is more that can be wrong.
motion=(--set "fibers/left/density=1" --set "fibers/right/density=1"
  --set "dynamics/integrator=generalized-alpha" --set "dynamics/end time=1e-6"
  --set "dynamics/time step=1e-6")
run two_fibers.prm "${motion[@]}" --output good
check "the unchanged motion fails" [ "$status" -eq 0 ]
while IFS='|' read -r parameter value allowed; do
  [[ -z $parameter ]] ||
    rejects two_fibers.prm "${motion[@]}" --set "$parameter=$value" -- \
      "'$parameter'" "'$value'" "$allowed"
done <<'END'
fibers/left/density|0|positive in a scene with dynamics
fibers/left/initial velocity|0; 0|three formulas
dynamics/end time|0|positive
dynamics/time step|0|positive
dynamics/smallest step|1|at most the time step
dynamics/largest step|5e-07|at least the time step
END
rejects two_fibers.prm "${motion[@]}" \
  --set "fibers/left/initial velocity=0; q*s; 0" -- \
  "'fibers/left/initial velocity'" "'q*s'" "a formula"
rejects two_fibers.prm "${motion[@]}" \
  --set "supports/held/displacement=0.1; 0; free" -- \
  "'supports/held/displacement'" "'0.1; 0; free'" "zero at time 0"
rejects two_fibers.prm "${motion[@]}" \
  --set "supports/held/tangent direction=t; 1; 0" -- \
  "'supports/held/tangent direction'" "'t; 1; 0'" "in a scene with dynamics"
rejects two_fibers.prm "${motion[@]}" --set "dynamics/integrator=IDA" -- \
  "'dynamics/tolerance'" "'0'" "positive for the integrator IDA"
rejects two_fibers.prm "${motion[@]}" --set "dynamics/integrator=IDA" \
  --set "dynamics/tolerance=1e-6" --set "dynamics/largest displacement=1" -- \
  "'dynamics/largest displacement'" "'1'" "which cannot bound it"
rejects two_fibers.prm "${motion[@]}" --set "dynamics/integrator=IDA" \
  --set "dynamics/tolerance=1e-6" --set "dynamics/energy tolerance=1" -- \
  "'dynamics/energy tolerance'" "'1'" "which cannot bound it"

# An integrator that cannot treat a term: forces without a potential.
no_potential=(--set "interactions/adhesion/law=offset-disks"
  --set "interactions/adhesion/interaction moments=false")
rejects two_fibers.prm "${motion[@]}" "${no_potential[@]}" \
  --set "dynamics/integrator=energy-conserving" -- "'dynamics/integrator'" \
  "'energy-conserving'" "'adhesion', which has no potential"
rejects two_fibers.prm "${motion[@]}" "${no_potential[@]}" \
  --set "dynamics/energy tolerance=1" -- "'dynamics/energy tolerance'" "'1'" \
  "'adhesion', which has no potential"
run two_fibers.prm "${motion[@]}" "${no_potential[@]}" --output good
check "generalized-alpha rejects forces without a potential" [ "$status" -eq 0 ]

# What a formula comes to while the run is under way: each step is checked.
run two_fibers.prm --set "load stepping/largest step=if(t < 6e-6, 2e-6, 0)" \
  --set "load stepping/first step=1e-6" --output good
one_line_with "'load stepping/largest step'" "'if(t < 6e-6, 2e-6, 0)'" \
  "positive at every time, but is 0 at t = 7e-06"
run two_fibers.prm --set "supports/held/at=start" \
  --set "supports/held/tangent=0; -1e5*t; 0" --output good
one_line_with "'supports/held/tangent'" "'0; -1e5*t; 0'" \
  "length 0 at t = 1e-05"

# Where nothing can be written: below a file, and in the place of one.
for directory in /dev/null/x two_fibers.prm/x two_fibers.prm; do
  rejects two_fibers.prm --output "$directory" -- \
    "'output/directory'" "'$directory'" "a directory that can be written"
done

# What cannot be read in the file: the message tells the line, here counted from
# the end of the scene that is right.
n_lines=$(wc -l <two_fibers.prm)
while IFS='|' read -r line text fragment allowed; do
  { cat two_fibers.prm && printf '%b' "$text"; } >bad.prm
  rejects bad.prm -- "Line <$((n_lines + line))> of file <bad.prm" \
    "$fragment" "$allowed"
done <<'END'
1|set radius = 1\n|No entry with name <radius>|--print-parameters
3|subsection fibers\nsubsection left\nset radis = 1\nend\nend\n|<radis>|--print-parameters
3|subsection fibers\nsubsection left\nset radius = -1\nend\nend\n|-1 for the entry named radius|Double 0
3|subsection fibers\nsubsection left\nset radius = thin\nend\nend\n|thin for the entry named radius|Double 0
1|subsection fibrs\nend\n|no such subsection to be entered: fibrs|--print-parameters
2|subsection fibers\nsubsection lft\nend\nend\n|entered: fibers.lft|'names' list
1|end\n|no subsection to leave|--print-parameters
1|left = 1\n|<left = 1> could not be parsed|'set'
1|include nowhere.prm\n|<nowhere.prm> cannot be opened|--print-parameters
END
{ cat two_fibers.prm && echo "subsection newton"; } >bad.prm
rejects bad.prm -- "'subsection' and 'end'" "<bad.prm>"
echo "# nothing" >bad.prm
rejects bad.prm -- "'fibers/names'" "''" "at least one name"

# The command line.
rejects -- "no scene" --help
: >empty.prm
rejects empty.prm -- "'empty.prm' cannot be read"
rejects missing.prm -- "'missing.prm' cannot be read"
rejects . -- "'.' cannot be read"
rejects two_fibers.prm empty.prm -- "'two_fibers.prm'" "'empty.prm'"
rejects two_fibers.prm --verbose -- "'--verbose'" "allowed are --set"
rejects two_fibers.prm --set -- "'--set' needs a value"
rejects two_fibers.prm --output -- "'--output' needs a value"
rejects two_fibers.prm --set "title" -- "'title'" "section/name=value"
rejects two_fibers.prm --set "titel=x" -- "'titel'" "'x'" --print-parameters
rejects two_fibers.prm --set "fibers/left/radis=1" -- \
  "'fibers/left/radis'" "'1'" --print-parameters
rejects two_fibers.prm --set "fibers/lft/radius=1" -- \
  "'fibers/lft/radius'" "'1'" --print-parameters

finish
