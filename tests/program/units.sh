#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# A scene does not know its units: the peeling scene without units, in nanometres
# and piconewtons and in metres and newtons takes the same steps and iterations, and
# its dimensionless results agree to 1e-9 up to the instability and to 1e-6 after
# it. So does the gap of two nanofibers that one of them finds. A fiber that has
# nothing to hold it is named.

source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

# in_units NAME LENGTH FORCE: the peeling scene with other units.
in_units() {
  awk -v L="$2" -v F="$3" '
    function put(value) { sub(/=.*/, sprintf("= %.17g", value)) }
    /set constants/              { print "set constants = l = " sprintf("%.17g", 5 * L) \
                                     ", R = " sprintf("%.17g", .02 * L) \
                                     ", g_eq = " sprintf("%.17g", 1e-3 * L); next }
    /set length /                { put(5 * L) }
    /set radius /                { put(.02 * L) }
    /set youngs modulus/         { put(1e5 * F / (L * L)) }
    /set equilibrium gap/        { put(1e-3 * L) }
    /set force minimum/          { put(-.1 * F / L) }
    /set regularization gap/     { put(8e-4 * L) }
    /set cutoff /                { put(.1 * L) }
    { print }' "$here/../../prm/peeling.prm" >"$1.prm"
  run "$1.prm" --output "$1" --set output/fields=false
  check "the scene in the units $1 fails" [ "$status" -eq 0 ]
}

# same_results OTHER LENGTH FORCE: reactions, gap and energies, each divided by its
# unit and compared with the largest one of the run without units.
same_results() {
  awk -v L="$2" -v F="$3" '
    FNR == NR && /^# [0-9]+: reaction x \(right\)/ { sub(/:/, "", $2); unit[$2] = F }
    FNR == NR && /^# [0-9]+: smallest gap/     { sub(/:/, "", $2); unit[$2] = L }
    FNR == NR && /^# [0-9]+: (strain|interaction) energy/ {
      sub(/:/, "", $2); unit[$2] = F * L }
    FNR == NR && /^# [0-9]+: iterations/       { sub(/:/, "", $2); iterations = $2 }
    FNR == NR && /^# [0-9]+: snap/             { sub(/:/, "", $2); snap = $2 }
    /^#/ { next }
    FNR == NR { ++n; time[n] = $2; count[n] = $iterations
                for (k in unit) { value[n, k] = $k
                  if ($k != "inf" && ($k > 0 ? $k : -$k) > scale[k])
                    scale[k] = ($k > 0 ? $k : -$k) }
                next }
    { ++m
      if ($snap == 1) passed = 1
      if ($2 - time[m] > 1e-12 || time[m] - $2 > 1e-12) exit 1
      if (!passed && $iterations != count[m]) exit 1
      for (k in unit) {
        if (value[m, k] == "inf" && $k == "inf") continue
        difference = $k / unit[k] - value[m, k]
        if (difference < 0) difference = -difference
        if (!(difference <= (passed ? 1e-6 : 1e-9) * scale[k])) {
          print "  line " m " column " k " differs by " difference / scale[k]
          exit 1 } } }
    END { for (k in unit) ++columns
          if (columns != 4 || m != n || m < 20 || !passed) exit 1 }' \
    plain/statistics.txt "$1/statistics.txt"
}

in_units plain 1 1
in_units metres 3.3e-10 7e-13
in_units large 7e6 3e9
check "the results in metres differ" same_results metres 3.3e-10 7e-13
check "the results in large numbers differ" same_results large 7e6 3e9

# gap_of DIRECTORY UNIT: the last smallest gap in thousandths of the unit.
gap_of() {
  awk -v unit="$2" '
    /^# [0-9]+: smallest gap/ { sub(/:/, "", $2); column = $2 }
    !/^#/ { gap = $column }
    END { printf "%.9f", gap / unit }' "$1/statistics.txt"
}

# adhesion NAME LENGTH FORCE: a fiber finds its equilibrium beside a rigid one.
adhesion() {
  awk -v L="$2" -v F="$3" '{
    while (match($0, /[LFP]\{[^}]*\}/)) {
      kind = substr($0, RSTART, 1)
      number = substr($0, RSTART + 2, RLENGTH - 3)
      factor = kind == "L" ? L : kind == "F" ? F / L : F / (L * L)
      $0 = substr($0, 1, RSTART - 1) sprintf("%.17g", number * factor) \
           substr($0, RSTART + RLENGTH) }
    print }' >"$1.prm" <<'END'
set coordinates = x, y
subsection fibers
  set names = left, right
  subsection left
    set centerline = 0; s; 0
    set length = L{1000}
    set radius = L{10}
    set youngs modulus = P{1000}
    set cells = 16
    set beam = rigid
  end
  subsection right
    set centerline = L{20.33}; s; 0
    set length = L{1000}
    set radius = L{10}
    set youngs modulus = P{1000}
    set cells = 16
  end
end
subsection supports
  set names = slide
  subsection slide
    set fibers = right
    set at = start
    set displacement = free; 0; free
  end
end
subsection interactions
  set names = adhesion
  subsection adhesion
    set law = disk-cylinder
    set source = right
    set target = left
    set equilibrium gap = L{0.3}
    set force minimum = F{-10}
    set cutoff = L{10}
  end
end
subsection load stepping
  set end time = 1
  set first step = 1
end
END
  run "$1.prm" --output "$1" --set output/fields=false
  check "the adhesion in $1 fails" [ "$status" -eq 0 ]
  check "the gap in $1 is $(gap_of "$1" "$2"), not 0.3" \
    awk -v gap="$(gap_of "$1" "$2")" 'BEGIN { exit !(gap > 0.299999 && gap < 0.300001) }'
}
adhesion nanometres 1 1
adhesion si_units 1e-9 1e-12

# A motion, whose numbers are formulas of the units: the same steps and energies.
cat >motion.prm <<'END'
set coordinates = x, y
set constants = L = 1, F = 1, T = 1
subsection fibers
  set names = left, right
  subsection left
    set centerline = 0; s; 0
    set length = 5*L
    set radius = 0.02*L
    set youngs modulus = 1e5*F/L^2
    set density = 1e-3*F*T^2/L^4
    set cells = 8
  end
  subsection right
    set centerline = 0.06*L; s; 0
    set length = 5*L
    set radius = 0.02*L
    set youngs modulus = 1e5*F/L^2
    set density = 1e-3*F*T^2/L^4
    set cells = 8
    set initial velocity = -10*L/T; 0; 0
  end
end
subsection interactions
  set names = lj
  subsection lj
    set law = disk-cylinder
    set source = left
    set target = right
    set equilibrium gap = 1e-3*L
    set force minimum = -0.01*F/L
    set regularization gap = 3e-4*L
    set cutoff = 0.1*L
  end
end
subsection dynamics
  set integrator = generalized-alpha
  set end time = 2.5e-3*T
  set time step = 1e-4*T
end
subsection output
  set fields = false
end
END
run motion.prm --output motion-plain
check "the motion fails" [ "$status" -eq 0 ]
run motion.prm --output motion-si \
  --set "constants=L = 3.3e-10, F = 7e-13, T = 2e-9"
check "the motion in metres fails" [ "$status" -eq 0 ]
same_motion() {
  awk '
    FNR == NR && /^# [0-9]+: total energy/ { sub(/:/, "", $2); column = $2 }
    /^#/ { next }
    FNR == NR { energy[++n] = $column; next }
    { ++m
      difference = $column / (7e-13 * 3.3e-10) - energy[m]
      if (difference < 0) difference = -difference
      if (!(difference <= 1e-8 * energy[1])) exit 1 }
    END { if (m != n || m < 26 || !(energy[1] > 0)) exit 1 }' \
    motion-plain/statistics.txt motion-si/statistics.txt
}
check "the motion in metres differs" same_motion

# A fiber at a hinge, with nothing else: refused before it drifts away.
cat >hinged.prm <<'END'
set coordinates = x, y
subsection fibers
  set names = held, loose
  subsection held
    set centerline = s; 1; 0
    set cells = 4
  end
  subsection loose
    set centerline = s; 0; 0
    set cells = 4
  end
end
subsection supports
  set names = held, hinge
  subsection held
    set fibers = held
    set at = start
    set displacement = 0; 0; 0
    set tangent = free; 0; 0
  end
  subsection hinge
    set fibers = loose
    set at = end
    set displacement = 0; t; 0
  end
end
subsection load stepping
  set first step = 1
end
END
run hinged.prm
one_line_with "'loose' can rotate freely" "'supports/names'"
for ranks in 1 2; do
  run_on "$ranks" hinged.prm --set "supports/hinge/displacement=free; t; 0"
  one_line_with "'loose' can" "freely" "'supports/names'"
done

finish
