#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# An error ends all ranks with one line, whether one rank has it or all of them.

source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

# A load whose formula has no value on a part of the second fiber.
cat >one_rank.prm <<'END_OF_SCENE'
set coordinates = x, y
subsection fibers
  set names = a, b
  subsection a
    set centerline = s; 0; 0
    set length     = 1
    set cells      = 8
    set youngs modulus = 1e8
  end
  subsection b
    set centerline = s; 1; 0
    set length     = 2
    set cells      = 8
    set youngs modulus = 1e8
  end
end
subsection supports
  set names = clamp
  subsection clamp
    set displacement = 0; 0; 0
    set tangent      = free; 0; 0
  end
end
subsection loads
  set names = weight
  subsection weight
    set at    = all
    set force = 0; -1e-3*t*sqrt(1.5 - s); 0
  end
end
subsection load stepping
  set first step = 0.5
end
END_OF_SCENE
cp "$here/two_fibers.prm" .

for ranks in 1 2 4; do
  SECONDS=0
  run_on "$ranks" one_rank.prm --output "one-$ranks"
  one_line_with "'loads/weight/force'" "sqrt(1.5 - s)" "finite" "1.5"
  check "it takes $SECONDS s on $ranks ranks" [ "$SECONDS" -le 30 ]

  # The same at the initial velocities, before the run.
  run_on "$ranks" one_rank.prm --output "one-$ranks" \
    --set "fibers/a/density=1" --set "fibers/b/density=1" \
    --set "dynamics/integrator=generalized-alpha" \
    --set "fibers/b/initial velocity=0; log(1.9 - s); 0"
  one_line_with "'fibers/b/initial velocity'" "log(1.9 - s)" "finite"

  # All ranks alike.
  run_on "$ranks" two_fibers.prm --set "fibers/right/centerline=0.039; s; 0"
  one_line_with "Fibers overlap" "-0.001"
  run_on "$ranks" missing.prm
  one_line_with "'missing.prm' cannot be read"
  run_on "$ranks" --calibrate 1e-3 missing.prm
  one_line_with "'missing.prm' cannot be read"

  # The first rank alone, which writes.
  run_on "$ranks" two_fibers.prm --output two_fibers.prm/below
  one_line_with "'output/directory'" "a directory that can be written"

  run_on "$ranks" two_fibers.prm --output "good-$ranks"
  check "the unchanged scene fails on $ranks ranks" [ "$status" -eq 0 ]
done

finish
