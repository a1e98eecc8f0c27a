#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# With `verification`, a scene prints energy and force of a pair of fibers by the
# full quadrature and by the law; without, it does not take the time.

source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

short=("$here/two_fibers.prm" --set "fibers/left/length=0.4"
  --set "fibers/right/length=0.4"
  --set "fibers/right/centerline=0.06; s; 0"
  --set "load stepping/end time=1e-8")

run "${short[@]}"
check "the run fails" [ "$status" -eq 0 ]
check "it is verified" [ "$(grep -c 'full,' "$captured/out")" -eq 0 ]

run "${short[@]}" --set "verification=full 6D quadrature"
check "the verified run fails" [ "$status" -eq 0 ]
check "no full quadrature" on_stdout 'left - right .* full, +[4-8] Gauss points'
check "no law without cutoff" on_stdout 'disk-cylinder, no cutoff'
# At g/R = 1, the energy of the law is 3.6 times that of parallel cylinders.
check "the error of the law is not what it is known to be" awk -F'|' '
  /disk-cylinder, no cutoff/ { n += $6 > 2.4 && $6 < 2.8 }
  END { exit n != 1 }' "$captured/out"

run "${short[@]}" --set "verification=full 6D quadrature" \
  --set "full 6D quadrature/cells=10"
check "the run within limits fails" [ "$status" -eq 0 ]
check "limits are not told" on_stdout 'too much for the limits'

finish
