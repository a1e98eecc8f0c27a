#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# Motions as whole runs: the same on 1, 2 and 4 ranks, by both integrators, and
# all steps on disk if a run ends in the middle.

source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

scene=$here/../../prm/snap.prm

# Until after the first contact, with fewer points.
short=(--set output/fields=false --set "dynamics/time step=2e-4"
  --set "dynamics/end time=2e-3" --set "interactions/coulomb/gauss points=3"
  --set "interactions/contact/gauss points=1")
ida=(--set dynamics/integrator=IDA --set dynamics/tolerance=1e-4
  --set "dynamics/largest displacement=0")
for ranks in 1 2 4; do
  run_on "$ranks" "$scene" "${short[@]}" --output "alpha-$ranks" \
    --set dynamics/integrator=generalized-alpha
  check "generalized-alpha on $ranks ranks fails" [ "$status" -eq 0 ]
  run_on "$ranks" "$scene" "${short[@]}" --output "conserving-$ranks" \
    --set dynamics/integrator=energy-conserving --set "dynamics/rho infinity=1"
  check "energy-conserving on $ranks ranks fails" [ "$status" -eq 0 ]
  run_on "$ranks" "$scene" "${short[@]}" "${ida[@]}" --output "ida-$ranks"
  check "IDA on $ranks ranks fails" [ "$status" -eq 0 ]
done

# same FIRST SECOND: energies and momenta agree to 1e-7 of the largest of each.
same() {
  awk '
    /^# [0-9]+: .*(energy$|momentum)/ { column = $2; sub(/:/, "", column)
                                       columns[column] = 1; next }
    /^#/ { next }
    FNR == NR { for (c in columns) { value[$1, c] = $c
                  if ($c > scale[c]) scale[c] = $c
                  if (-$c > scale[c]) scale[c] = -$c }
                n = $1; next }
    { ++m
      for (c in columns) { difference = $c - value[$1, c]
        if (difference < 0) difference = -difference
        if (!(difference <= 1e-7 * scale[c])) { print c, $1, $c, value[$1, c]
                                                exit 1 } } }
    END { if (m != n + 1 || m < 10) exit 1 }' \
    "$1/statistics.txt" "$2/statistics.txt"
}
for method in alpha conserving ida; do
  check "$method differs on 2 ranks" same $method-1 $method-2
  check "$method differs on 4 ranks" same $method-1 $method-4
done

# The charge grows from zero and does work; beyond that the energy is constant,
# from the beginning through the first contact.
balanced() {
  awk '
    /^# [0-9]+: energy balance/ { balance = $2; sub(/:/, "", balance); next }
    /^# [0-9]+: total energy/ { total = $2; sub(/:/, "", total); next }
    /^#/ { next }
    { ++n
      if ($balance > largest) largest = $balance
      if (-$balance > largest) largest = -$balance
      if (-$total > scale) scale = -$total }
    END { if (n < 10 || !(scale > 0.1) || !(largest < 1e-7 * scale)) exit 1 }' \
    "$1/statistics.txt"
}
check "the energy is not conserved" balanced conserving-1

# A support whose formula ends in the middle of the run.
cp "$here/two_fibers.prm" .
run two_fibers.prm --set "fibers/left/density=1" --set "fibers/right/density=1" \
  --set "dynamics/integrator=generalized-alpha" --set "dynamics/end time=1e-3" \
  --set "dynamics/time step=1e-4" \
  --set "supports/pulled/displacement=1e-3*(sqrt(5e-4-t)-sqrt(5e-4)); 0; free" \
  --output broken
one_line_with "'supports/pulled/displacement'" finite
check "the steps before the end are not on disk" \
  [ "$(grep -vc '^#' broken/statistics.txt)" -ge 3 ]

# A step that cannot be solved.
run two_fibers.prm --set "fibers/left/density=1" --set "fibers/right/density=1" \
  --set "dynamics/integrator=generalized-alpha" --set "dynamics/end time=1e-3" \
  --set "dynamics/time step=1e-4" --set "newton/iterations=1" \
  --set "dynamics/smallest step=5e-5" --output unsolved
one_line_with "The time step from 0 to 5e-05 has no solution" "on disk"
check "the initial state is not on disk" \
  [ "$(grep -vc '^#' unsolved/statistics.txt)" -eq 1 ]

finish
