# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot fiber_ends.gnuplot in the folder with fiber_ends.csv draws fiber_ends.png.

set terminal pngcairo size 1200,900 font 'sans,11'
set output 'fiber_ends.png'
set datafile separator ','
set grid
set key bottom center maxrows 3 font ',9'
rows(configuration, method) = sprintf( \
  "< grep '^%s,van der Waals,%s,' fiber_ends.csv | awk -F, '$5 == 0.1'", configuration, method)
set multiplot layout 2,2 title 'Ends of fibers, van der Waals, g/R = 0.1'
array methods[6] = ['disk-disk', 'offset-disks', 'disk-cylinder', 'disk-cylinder finite', 'oriented-disk-cylinder', 'tabulated-disk-cylinder']
array titles[6] = ['SSIP', 'ISSIP', 'SBIP, clamped', 'SBIP, finite', 'closed form', 'tabulated']
array cases[4] = ['sliding', 'sliding: axial force', 'crossing at 90 degrees: the source ends', 'crossing at 90 degrees: the target ends']
array quantities[4] = ['energy', 'axial force', 'energy', 'energy']
array fields[4] = [10, 11, 10, 10]
set logscale y
set format y '10^{%T}'
do for [c=1:4] {
  set yrange [1e-7:1e2]
  set title cases[c]
  set xlabel (c <= 2 ? 'shift / R, of fibers of 10 R' : 'overhang / R')
  set ylabel 'relative error, '.quantities[c]
  plot for [i=1:6] rows(cases[c], methods[i]) using 7:(abs(column(fields[c]))) \
         with linespoints pointsize .8 pointtype i linecolor i title titles[i]
}
