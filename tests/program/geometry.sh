#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# A fiber has the same deflection at every size, at every place, and read from a
# mesh file with few digits, with double nodes or from another folder.

source "$(dirname "${BASH_SOURCE[0]}")/expect.sh"

# tip DIRECTORY: the displacement x y z of the loaded point in the last step.
tip() {
  awk '/^# *[0-9]+: point displacement/ { column[++n] = $2 + 0 }
       !/^#/ { x = $column[1]; y = $column[2]; z = $column[3] }
       END { print x, y, z }' "$1/statistics.txt"
}

# tip_is DIRECTORY UNIT X Y Z TOLERANCE: the tip moves by X Y Z times UNIT, up
# to TOLERANCE times UNIT.
tip_is() {
  local moved
  moved=$(tip "$1")
  check "the tip moves by $moved, not by $3 $4 $5 times $2" \
    awk -v m="$moved" -v unit="$2" -v x="$3" -v y="$4" -v z="$5" -v tol="$6" '
      function far(a, b) { a = a / unit - b; return a > tol || a < -tol }
      BEGIN { split(m, d)
              exit far(d[1], x) || far(d[2], y) || far(d[3], z) }'
}

succeeds() {
  check "the exit status is $status, not 0" [ "$status" -eq 0 ]
}

cantilever() {
  cat <<'END'
subsection supports
  set names = clamp
  subsection clamp
    set at           = start
    set displacement = 0; 0; 0
    set tangent      = 0; 0; 0
  end
end
subsection load stepping
  set first step = 1
end
subsection output
  set fields = false
end
END
}

# arc_small: a quarter circle of radius r, in units in which all that the mesh
# of the curve depends on is the same.

cat >arc.prm <<'END'
set coordinates = x, y
set constants   = r = 1, offset = 0
subsection fibers
  set names = arc
  subsection arc
    set centerline     = offset + r*cos(s/r); offset + r*sin(s/r); 0
    set length         = pi/2*r
    set radius         = r/60
    set youngs modulus = 1e9
    set cells          = 16
  end
end
subsection loads
  set names = tip
  subsection tip
    set force  = 0; -1e-12*(r/6e-7)^2*t; 0
  end
end
END
cantilever >>arc.prm
for r in 6e-7 1e-9 1 1e9; do
  for offset in 0 100; do
    run arc.prm --set "constants=r = $r, offset = $offset*r" --output arc \
      --set "newton/residual tolerance=1e-11*1e-12*(r/6e-7)^2" \
      --set "newton/increment tolerance=1e-8*max(r, 1e-3)"
    succeeds
    # -2.22246e-8 for r = 6e-7; linear theory gives -2.16e-8.
    tip_is arc "$r" -0.0226520 -0.0370410 0 2e-6
  done
done

# far_away: all digits of the deflection but those of the offset.

cat >far_away.prm <<'END'
set constants = offset = 2e4
subsection fibers
  set names = rod
  subsection rod
    set centerline     = offset + 0.6*s; offset + 0.8*s; offset
    set length         = 1
    set radius         = 0.01
    set youngs modulus = 1e6
    set cells          = 8
  end
end
subsection loads
  set names = tip
  subsection tip
    set force  = 0; 0; 1e-3*t
  end
end
END
cantilever >>far_away.prm
for offset in 0 -1 2e4; do
  run far_away.prm --set "constants=offset = $offset" --output far_away
  succeeds
  tip_is far_away 1 -6.463832e-4 -8.618442e-4 4.2362973e-2 1e-9
done
run far_away.prm --set "constants=offset = 1e8" --output far_away
one_line_with "'fibers/rod/centerline'" "nearer to the origin" "(1e+08,"

# A formula that comes back to its start is a ring: pulled across, it widens by
# (pi/4 - 2/pi) F r^3/(E I), here with E I = 1 (Timoshenko).

cat >ring.prm <<'END'
set coordinates = x, y
subsection fibers
  set names = ring
  subsection ring
    set centerline     = cos(s); sin(s); 0
    set length         = 2*pi
    set radius         = 0.01
    set youngs modulus = 4/(pi*0.01^4)
    set cells          = 24
  end
end
subsection supports
  set names = held
  subsection held
    set at           = start
    set displacement = 0; 0; 0
    set tangent      = 0; free; 0
  end
end
subsection loads
  set names = pull
  subsection pull
    set at    = 3.14159
    set force = -1e-4*t; 0; 0
  end
end
subsection load stepping
  set first step = 1
end
END
run ring.prm --output ring
succeeds
check "nothing says that it is a ring" on_stdout "'ring' comes back to its start"
tip_is ring 1 -1.48779e-5 0 0 5e-9

# mesh_file: in a folder of its own, with the six digits that programs write,
# and with a node that is there twice.

mkdir -p scenes
cat >scenes/mesh.prm <<'END'
subsection fibers
  set names = rod
  subsection rod
    set mesh file      = tilted6.vtk
    set radius         = 0.01
    set youngs modulus = 1.2732395447351628e8
  end
end
subsection loads
  set names = tip
  subsection tip
    set force  = 0; -0.01*t; 0
  end
end
END
cantilever >>scenes/mesh.prm
vtk() {
  cat <<'END'
# vtk DataFile Version 3.0
line
ASCII
DATASET UNSTRUCTURED_GRID
END
}
{
  vtk
  cat <<'END'
POINTS 7 double
0 0 0
0.116667 0.0722222 0.0238095
0.233333 0.144444 0.047619
0.35 0.216667 0.0714286
0.466667 0.288889 0.0952381
0.583333 0.361111 0.119048
0.7 0.433333 0.142857
CELLS 1 8
7 0 1 2 3 4 5 6
CELL_TYPES 1
4
END
} >scenes/tilted6.vtk
{
  vtk
  cat <<'END'
POINTS 8 double
0 0 0
0.166667 0 0
0.333333 0 0
0.5 0 0
0.5 0 0
0.666667 0 0
0.833333 0 0
1 0 0
CELLS 6 18
2 0 1  2 1 2  2 2 3  2 4 5  2 5 6  2 6 7
CELL_TYPES 6
3 3 3 3 3 3
END
} >scenes/duplicate.vtk

# With E I = 1, -F l^3/3 e_n (e_n . e_y) for the part of the force across.
run scenes/mesh.prm --output tilted
succeeds
check "nothing says that nodes were moved" \
  on_stdout "'scenes/tilted6.vtk' .* straight within the digits"
tip_is tilted 1 8.4433e-4 -1.42476e-3 1.7231e-4 2e-7

# The parameters that are saved repeat the run from another folder.
mkdir -p elsewhere
cp tilted/parameters.prm elsewhere/
run elsewhere/parameters.prm --output again
succeeds
tip_is again 1 8.4433e-4 -1.42476e-3 1.7231e-4 2e-7

run scenes/mesh.prm --output joined --set "fibers/rod/mesh file=duplicate.vtk"
succeeds
check "nothing says that a node was joined" \
  on_stdout '1 node\(s\) at the place of another one.* node 4 at \(0\.5, 0, 0\)'
tip_is joined 1 -6.6658e-6 -3.33330e-3 0 1e-8

# The same on two ranks.
run_on 2 scenes/mesh.prm --output joined_2 \
  --set "fibers/rod/mesh file=duplicate.vtk"
succeeds
check "two ranks differ" [ "$(tip joined)" = "$(tip joined_2)" ]

# A mark that some editors write is no part of the scene.
{ printf '\xEF\xBB\xBF' && cat far_away.prm; } >marked.prm
run marked.prm --output marked
succeeds
{ printf '\xEF\xBB\xBF' && echo "set title = included"; } >included.prm
echo "include included.prm" >including.prm
run including.prm --output marked
one_line_with "included.prm" "without the UTF-8 byte order mark"

finish
