#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# Gaps are those between curves, also between two integration points, and no
# step takes fibers through each other: it is repeated smaller, or the run ends
# with one line.

source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

# A straight fiber across another one, 2 long, radius 0.02, gap 0.02.
# scene NAME INTERACTION STEPPING
scene() {
  cat >"$1.prm" <<END
set constants = drop = 0.3, shift = 0
subsection fibers
  set names = low, high
  subsection low
    set centerline     = s - 1; 0; 0
    set length         = 2
    set radius         = 0.02
    set youngs modulus = 1e6
    set density        = 1
    set cells          = 8
  end
  subsection high
    set centerline     = shift; s - 1; 0.06
    set length         = 2
    set radius         = 0.02
    set youngs modulus = 1e6
    set density        = 1
    set cells          = 8
    set initial velocity = 0; 0; -100
  end
end
subsection supports
  set names = low, high
  subsection low
    set fibers       = low
    set at           = start, end
    set displacement = 0; 0; 0
  end
  subsection high
    set fibers       = high
    set at           = start, end
    set displacement = 0; 0; -drop*t
  end
end
subsection interactions
  set names = contact
  subsection contact
    set source = high
    set target = low
$2
  end
end
subsection load stepping
  set end time     = 1
  set first step   = 1
  set largest step = 1
end
subsection output
  set fields = false
end
END
}
steric='    set exponents = 12
    set prefactors = 1e-16
    set cutoff = 0.1'
penalty='    set law = penalty-contact
    set penalty = 1e4'

# same_end COLUMN: whether the last lines of both runs agree in it to 1e-6.
same_end() {
  awk -v c="$1" '!/^#/ { last[FILENAME] = $c } END {
    for (f in last) x[++n] = last[f]
    if (x[1] == 0) exit 1
    d = x[1] - x[2]; exit !(n == 2 && d * d <= 1e-12 * x[1] * x[1]) }' \
    one_step/statistics.txt small_steps/statistics.txt
}

# pressed_across: one step of 0.3 through the other fiber is not accepted, and
# what comes out is what small steps give.
for law in steric penalty; do
  scene "$law" "${!law}"
  run "$law.prm" --output one_step
  check "$law in one step fails" [ "$status" -eq 0 ]
  check "$law: no step was rejected" on_stdout 'in [1-9][0-9]* rejected steps'
  check "$law: the fibers are not in contact" \
    on_stdout '^Smallest gap of all steps: [-0-9]'
  run "$law.prm" --output small_steps --set "load stepping/first step=0.02" \
    --set "load stepping/largest step=0.02"
  check "$law in small steps fails" [ "$status" -eq 0 ]
  check "the columns are other ones" \
    grep -q "^# 9: reaction z (low)" one_step/statistics.txt
  check "the last columns are other ones" \
    grep -q "^# 18: smallest gap" one_step/statistics.txt
  check "$law: the reactions differ" same_end 9
  check "$law: the gaps differ" same_end 18
done

# The smallest step ends the run, and the line says who would pass through whom.
run steric.prm --output coarse --set "load stepping/instability resolution=0.9" \
  --set "load stepping/first step=1" \
  --set "load stepping/pass instabilities=false"
one_line_with "pass through each other" "'high' (at s = 1" "'low'" \
  "load stepping/instability resolution"

# thrown: in one time step of 2.5 diameters.
for integrator in energy-conserving generalized-alpha; do
  run penalty.prm --output thrown --set "constants=drop = 0, shift = 0" \
    --set "supports/high/displacement=free; free; free" --set "dynamics/integrator=$integrator" \
    --set "dynamics/end time=0.002" --set "dynamics/time step=1e-3" \
    --set "dynamics/smallest step=9e-4"
  one_line_with "pass through each other" "'high' (at s = 1" "'low'"
done
run penalty.prm --output thrown --set "constants=drop = 0, shift = 0" \
  --set "supports/high/displacement=free; free; free" --set "dynamics/integrator=IDA" \
  --set "dynamics/tolerance=1e-5" \
  --set "dynamics/end time=0.002" --set "dynamics/time step=1e-3"
one_line_with "'high' (at s = 1" "'low'"

# long_cells: a crossing between two points is contact, wherever it is.
penalty='    set law = penalty-contact
    set penalty = 1e3'
scene long "$penalty"
for shift in 0 0.1 0.137; do
  run long.prm --output "long_$shift" \
    --set "constants=drop = 0.06, shift = $shift" \
    --set "fibers/low/cells=1" --set "fibers/high/cells=1" \
    --set "fibers/low/radius=0.002" --set "fibers/high/radius=0.002"
  check "a crossing at $shift is not seen" [ "$status" -eq 0 ]
  check "a crossing at $shift has no gap" \
    on_stdout 'Smallest gap of all steps: -'
done

# With points by hand there is no force there, but the gap is seen: no solution.
run long.prm --output by_hand --set "constants=drop = 0.08, shift = 0.137" \
  --set "interactions/contact/integration tolerance=0" \
  --set "fibers/low/cells=1" --set "fibers/high/cells=1" \
  --set "fibers/low/radius=0.002" --set "fibers/high/radius=0.002"
check "points too far apart are accepted" [ "$status" -eq 1 ]
check "nothing warns of points too far apart" \
  on_stdout "^warning: .*'interactions/contact/integration segments'"

finish
