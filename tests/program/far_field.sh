#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# Clusters of cells for far pairs as whole runs: the same on 1, 2 and 4 ranks, and
# within the tolerance of the sum over all pairs, in equilibrium and in motion.

source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

brush=$here/../../prm/charged_brush.prm
snap=$here/../../prm/snap.prm
tolerance="interactions/coulomb/far field tolerance"
static=(--set output/fields=false --set "fibers/brush/copies=4, 3"
  --set "load stepping/end time=0.01")
motion=(--set output/fields=false --set "dynamics/time step=2e-4"
  --set "dynamics/end time=2e-3" --set "interactions/coulomb/gauss points=4")

for ranks in 1 2 4; do
  run_on "$ranks" "$brush" "${static[@]}" --output "static-$ranks"
  check "the brush on $ranks ranks fails" [ "$status" -eq 0 ]
  run_on "$ranks" "$snap" "${motion[@]}" --set "$tolerance=1e-4" \
    --output "motion-$ranks"
  check "the motion on $ranks ranks fails" [ "$status" -eq 0 ]
done
run "$brush" "${static[@]}" --set "$tolerance=0" --output static-all
check "the brush with all pairs fails" [ "$status" -eq 0 ]
run "$snap" "${motion[@]}" --output motion-all
check "the motion with all pairs fails" [ "$status" -eq 0 ]

# largest_difference FIRST SECOND: of the energies, relative to the largest of each.
largest_difference() {
  awk '
    /^# [0-9]+: .*energy/ { column = $2; sub(/:/, "", column)
                            columns[column] = 1; next }
    /^#/ { next }
    FNR == NR { for (c in columns) { value[$1, c] = $c
                  if ($c > scale[c]) scale[c] = $c
                  if (-$c > scale[c]) scale[c] = -$c }
                n = $1; next }
    { m = $1
      for (c in columns) { difference = $c - value[$1, c]
        if (difference < 0) difference = -difference
        if (scale[c] > 0 && difference / scale[c] > largest)
          largest = difference / scale[c] } }
    END { print (m == n && n >= 2 ? largest : 1) }' \
    "$1/statistics.txt" "$2/statistics.txt"
}
below() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b) }'; }

for kind in static motion; do
  for ranks in 2 4; do
    check "$kind differs on $ranks ranks" \
      below "$(largest_difference $kind-1 "$kind-$ranks")" 1e-7
  done
done
difference=$(largest_difference static-all static-1)
check "the brush differs by $difference from all pairs" below "$difference" 1e-2
check "the brush knows no clusters" below 1e-12 "$difference"
difference=$(largest_difference motion-all motion-1)
check "the motion differs by $difference from all pairs" below "$difference" 1e-4
check "the motion knows no clusters" below 1e-12 "$difference"
finish
