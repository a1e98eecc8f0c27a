#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# A run that gives up says what failed, where, by how much and what to change: the
# reason of Newton's method stands before that of whatever gave up after it.

source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

cp "$here/two_fibers.prm" .

# Pressed below the regularization gap.
pressed=(--set "supports/pulled/displacement=-1e-3*t; 0; free"
  --set "load stepping/end time=1" --set "load stepping/instability resolution=0.1"
  --set output/fields=false)
gap="the gap is 0.000[0-7][0-9]* between 'left' \(at s = [0-9.e-]+\) and 'right', below 0.0008: lower 'interactions/adhesion/regularization gap'"
run two_fibers.prm "${pressed[@]}"
one_line_with "The load step from time" "has no solution" \
  "'load stepping/instability resolution', 0.1, allows no shorter one" "on disk"
check "Newton's reason is not the first" \
  grep -qE "no solution: $gap" "$captured/err"

check "the same reason is told twice" \
  [ "$(grep -o 'the gap is' "$captured/err" | wc -l)" -eq 1 ]

# Pressed into each other at once, where no motion helps.
run two_fibers.prm "${pressed[@]}" --set "load stepping/first step=1" \
  --set "load stepping/instability resolution=1" \
  --set "supports/pulled/displacement=-0.01*t; 0; free"
one_line_with "has no solution" \
  "; the overdamped motion finds no state of lower energy, in its smallest step because fibers overlap, with the gap -0.0"
check "Newton's reason is not the first" \
  grep -qE "no solution: the (residual|gap)[^;]*; the" "$captured/err"

run two_fibers.prm "${pressed[@]}" --set "load stepping/pass instabilities=false"
one_line_with "'load stepping/pass instabilities' is false"
check "Newton's reason is missing" grep -qE "no solution: $gap" "$captured/err"

run two_fibers.prm "${pressed[@]}" \
  --set "interactions/adhesion/regularization gap=3e-4" \
  --set "supports/pulled/displacement=-5e-4*t; 0; free"
check "it does not help to lower the regularization gap" [ "$status" -eq 0 ]
check "the summary does not tell the place of the smallest gap" \
  on_stdout "^Smallest gap of all steps: 0.000[0-9]+ between 'left' \(at s = [0-9.]+\) and 'right' in step [1-9]"
check "the summary does not tell that no gap is regularized" \
  on_stdout "^'adhesion' is regularized below 0.0003: no step has a smaller gap"

# No equilibrium to begin with.
run two_fibers.prm --set "interactions/adhesion/regularization gap=1.2e-3" \
  --output start
one_line_with "no equilibrium at time 0" "between 'left'" "and 'right'" \
  "below 0.0012: lower 'interactions/adhesion/regularization gap'" "grow from zero"

# Nothing is told about gaps that no step has.
run two_fibers.prm --set "fibers/right/centerline=1; s; 0"
check "the run fails" [ "$status" -eq 0 ]
check "the summary tells of a gap" on_stdout "^No fibers have come near enough"
check "the summary tells what was not checked" \
  [ "$(grep -c 'no step has a smaller gap' "$captured/out")" -eq 0 ]

# Small numbers have digits.
run two_fibers.prm --set "constants=l = 5e-9, g_eq = 1e-12" \
  --set "fibers/left/length=5e-9" --set "fibers/right/length=5e-9" \
  --set "fibers/left/radius=2e-11" --set "fibers/right/radius=2e-11" \
  --set "fibers/right/centerline=3.9e-11; s; 0"
one_line_with "Fibers overlap" "-1e-12"
run two_fibers.prm --set "load stepping/end time=1e-9"
check "the time has no digits" on_stdout '^step +1  t 1e-09 '

finish
