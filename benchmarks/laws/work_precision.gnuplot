# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot work_precision.gnuplot in the folder with work_precision.csv draws work_precision.png.

set terminal pngcairo size 1200,900 font 'sans,11'
set output 'work_precision.png'
set datafile separator ','
set grid
set key font ',9' outside right
set multiplot layout 2,2 title 'Two cylinders crossing at 45°: error of the energy over CPU time'
set logscale xy
set format xy '10^{%T}'
set xlabel 'CPU time [s]'
set ylabel 'relative error of the energy'
set yrange [1e-7:1e2]
array methods[9] = ['6D plain', '6D hierarchical', 'disk-disk', 'offset-disks', 'disk-cylinder', 'oriented-disk-cylinder', 'section-quadrature 4 x 9', 'section-quadrature 12 x 24', 'tabulated-disk-cylinder']
array titles[9] = ['6D plain', '6D hierarchical', 'SSIP', 'ISSIP', 'SBIP', 'closed form', '4 x 9', '12 x 24', 'tabulated']
rows(gap, potential, method) = sprintf( \
  "< awk -F, '$14 == 1 && $5 == %g && $2 == \"%s\" && $3 == \"%s\"' work_precision.csv", gap, potential, method)
do for [potential in "'van der Waals' 'steric'"] {
  do for [gap in '0.1 0.01'] {
    set title potential.', g/R = '.gap
    plot for [i=1:9] rows(gap + 0, potential, methods[i]) using 12:(abs($10)) \
           with linespoints pointsize .8 pointtype i linecolor (i == 9 ? 10 : i) title titles[i]
  }
}
