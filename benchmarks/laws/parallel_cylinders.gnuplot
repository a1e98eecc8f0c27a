# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot parallel_cylinders.gnuplot in the folder with parallel_cylinders.csv draws parallel_cylinders.png.

set terminal pngcairo size 1200,900 font 'sans,11'
set output 'parallel_cylinders.png'
set datafile separator ','
set grid
set key font ',9'
rows(configuration, potential, method) = \
  sprintf("< grep '^%s,%s,%s,' parallel_cylinders.csv", configuration, potential, method)
set multiplot layout 2,2 title 'Two infinite parallel cylinders (SSIP Fig. 9, SBIP Fig. 4a)'
set logscale xy
set format xy '10^{%T}'
set xlabel 'g/R'
case = 'parallel cylinders'
array methods[6] = ['disk-disk', 'offset-disks', 'disk-cylinder', 'oriented-disk-cylinder', 'tabulated-disk-cylinder', 'monopole']
array titles[6] = ['SSIP', 'ISSIP', 'SBIP', 'closed form', 'tabulated', 'monopole']

vdw = 'van der Waals'
set yrange [1e-12:1e10]
set ylabel '-energy per length / ρ_1ρ_2C'
set title 'van der Waals'
plot rows(case, vdw, '2D reduction') using 5:(-$8) with lines linewidth 4 \
       linecolor rgb 'gray' title 'exact', \
     for [i=1:6] rows(case, vdw, methods[i]) using 5:(-$8) with linespoints \
       pointsize .6 pointtype i linecolor i title titles[i]
unset yrange

set yrange [1e-8:1e3]
set ylabel 'relative error of the energy'
set key bottom left
do for [potential in "'van der Waals' 'steric' 'Lennard-Jones'"] {
  set title potential
  plot for [i=1:6] rows(case, potential, methods[i]) using 5:(abs($10)) \
         with linespoints pointsize .6 pointtype i linecolor i title titles[i]
}
