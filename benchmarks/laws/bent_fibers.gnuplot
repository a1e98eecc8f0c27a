# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot bent_fibers.gnuplot in the folder with bent_fibers.csv draws bent_fibers.png.

set terminal pngcairo size 1200,900 font 'sans,11'
set output 'bent_fibers.png'
set datafile separator ','
set grid
set key font ',9'
rows(configuration, method) = sprintf( \
  "< grep '^%s,van der Waals,%s,' bent_fibers.csv | awk -F, '$5 == 0.1'", configuration, method)
set multiplot layout 2,2 title 'Two fibers, one or both bent into an arc: error of the energy, van der Waals, g/R = 0.1'
set xlabel 'R κ'
set ylabel 'relative error of the energy'
set xrange [0:.2]
set yrange [-.4:1]
array methods[4] = ['offset-disks', 'disk-cylinder', 'oriented-disk-cylinder', 'tabulated-disk-cylinder']
array titles[4] = ['ISSIP', 'SBIP', 'closed form', 'tabulated']
array cases[4] = ['beside: target bent away', 'beside: source bent away', 'nested: the source inside', 'crossing at 90 degrees: target bent towards']
do for [c=1:4] {
  set title cases[c]
  plot for [i=1:4] rows(cases[c], methods[i]) using 13:10 with linespoints \
         pointsize .8 pointtype i linecolor i title titles[i]
}
