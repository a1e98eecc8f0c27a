#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# The peeling curve, from the force peak through the pull-off, is the same on 1, 2
# and 4 ranks to 1e-8 of its largest force. So is its beginning with the tabulated
# law, whose targets end: their zones are integrated over in a second pass.

source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

scene=$here/../../prm/peeling.prm
for ranks in 1 2 4; do
  run_on "$ranks" "$scene" --output "ranks-$ranks" --set output/fields=false
  check "the run on $ranks ranks fails" [ "$status" -eq 0 ]
done
for ranks in 1 2; do
  run_on "$ranks" "$scene" --output "finite-$ranks" --set output/fields=false \
    --set interactions/adhesion/law=tabulated-disk-cylinder \
    --set "load stepping/end time=0.1"
  check "the run with finite targets on $ranks ranks fails" [ "$status" -eq 0 ]
done

same_curve() {
  awk '
    /^# [0-9]+: reaction x \(right\)/ { reaction = $2; sub(/:/, "", reaction) }
    /^#/ { next }
    FNR == NR { time[$1] = $2; force[$1] = $reaction; n = $1
                if ($reaction > scale) scale = $reaction; next }
    { ++m
      if ($2 != time[$1]) exit 1
      difference = $reaction - force[$1]
      if (difference < 0) difference = -difference
      if (!(difference <= 1e-8 * scale)) exit 1 }
    END { if (m != n + 1 || m < 20 || !(scale > 0)) exit 1 }' \
    "$1-1/statistics.txt" "$1-$2/statistics.txt"
}

check "the curve differs on 2 ranks" same_curve ranks 2
check "the curve differs on 4 ranks" same_curve ranks 4
check "the curve with finite targets differs" same_curve finite 2
finish
