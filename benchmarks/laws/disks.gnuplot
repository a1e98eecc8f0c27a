# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot disks.gnuplot in the folder with disks.csv draws disks.png.

set terminal pngcairo size 1200,480 font 'sans,11'
set output 'disks.png'
set datafile separator ','
set grid
set key font ',9'
rows(configuration, potential, method) = \
  sprintf("< grep '^%s,%s,%s,' disks.csv", configuration, potential, method)
set multiplot layout 1,2 title 'Two disks, van der Waals (SSIP Fig. 8 and 10a)'
set logscale xy
set format xy '10^{%T}'
set xlabel 'g/R'
set ylabel '-energy per length^2 / ρ_1ρ_2C'
set yrange [1e-13:1e9]
array methods[5] = ['disk-disk', 'monopole', 'quadrupole', '4D,16\^4 points', '4D,32\^4 points']
array titles[5] = ['SSIP, small gaps', 'SSIP, large gaps', 'quadrupole', '4D, 16^4 points', '4D, 32^4 points']
do for [case in "'disks in one plane' 'perpendicular disks'"] {
  set title case
  plot rows(case, 'van der Waals', '2D/3D reduction') using 5:(-$8) with lines \
         linewidth 4 linecolor rgb 'gray' title 'exact', \
       for [i=1:5] rows(case, 'van der Waals', methods[i]) using 5:(-$8) \
         with linespoints pointsize .6 pointtype i linecolor i title titles[i]
}
