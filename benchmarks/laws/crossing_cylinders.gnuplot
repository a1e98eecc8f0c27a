# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot crossing_cylinders.gnuplot in the folder with crossing_cylinders.csv draws crossing_cylinders.png.

set terminal pngcairo size 1200,900 font 'sans,11'
set output 'crossing_cylinders.png'
set datafile separator ','
set grid
set key font ',9'
rows(configuration, potential, method) = \
  sprintf("< grep '^%s,%s,%s,' crossing_cylinders.csv", configuration, potential, method)
set multiplot layout 2,2 title 'Two crossing cylinders (SSIP Fig. 10b, SBIP Fig. 4b and 5)'
set logscale xy
set format xy '10^{%T}'
array methods[6] = ['disk-disk', 'offset-disks', 'disk-cylinder', 'oriented-disk-cylinder', 'tabulated-disk-cylinder', 'monopole']
array titles[6] = ['SSIP', 'ISSIP', 'SBIP', 'closed form', 'tabulated', 'monopole']

vdw = 'van der Waals'
case = 'crossing at 90 degrees'
set xlabel 'g/R'
set yrange [1e-9:1e8]
set ylabel '-energy / ρ_1ρ_2C'
set title 'van der Waals, 90°'
plot rows(case, vdw, '1D reduction') using 5:(-$8) with lines linewidth 4 \
       linecolor rgb 'gray' title 'exact', \
     for [i=1:6] rows(case, vdw, methods[i]) using 5:(-$8) with linespoints \
       pointsize .6 pointtype i linecolor i title titles[i]

set yrange [1e-7:1e3]
set ylabel 'relative error of the energy'
set key bottom left
do for [potential in "'van der Waals' 'steric'"] {
  set title potential.', 90°'
  plot for [i=1:6] rows(case, potential, methods[i]) using 5:(abs($10)) \
         with linespoints pointsize .6 pointtype i linecolor i title titles[i]
}

set title 'van der Waals, g/R = 10^{-3}'
set xlabel 'sin α'
set ylabel '-energy sin α / ρ_1ρ_2C'
set key top left
set yrange [1e3:1e6]
set logscale y
plot rows('all angles', vdw, '1D reduction') \
       using (sin($6*pi/180)):(-$8*sin($6*pi/180)) with lines linewidth 4 \
       linecolor rgb 'gray' title 'exact', \
     for [i=1:5] rows('all angles', vdw, methods[i]) \
       using (sin($6*pi/180)):(-$8*sin($6*pi/180)) with linespoints \
       pointsize .6 pointtype i linecolor i title titles[i]
