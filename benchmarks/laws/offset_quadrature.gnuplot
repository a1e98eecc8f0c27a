# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot offset_quadrature.gnuplot in the folder with offset_quadrature.csv draws offset_quadrature.png.

set terminal pngcairo size 1500,480 font 'sans,11'
set output 'offset_quadrature.png'
set datafile separator ','
set grid
set key font ',9'
set multiplot layout 1,3 title 'Force between a section and a straight fiber (ISSIP Fig. 14b, 20b, 21b)'
rows(figure, line) = sprintf("< grep '^%s,%s,' offset_quadrature.csv", figure, line)
set logscale y
set format y '10^{%T}'
set ylabel 'relative error of the force'

set xlabel 'cutoff radius / R'
plot for [gap in '0.0004 0.0008 0.001 0.0015 0.002'] rows('cutoff', gap) \
       using 3:4 with linespoints pointsize .6 title 'gap '.gap

set logscale x
set xrange [800:12800]
set xlabel 'points per length'
set xtics (800, 1600, 3200, 6400, 12800)
plot for [order=1:5] rows('points', sprintf('%d', order)) using 3:4 with lines \
       title sprintf('order %d', order), \
     '+' using (3200.):(3.4e-5) every ::0::0 with points pointtype 7 \
       linecolor rgb 'black' title 'published'

unset logscale x
set xrange [*:*]
set xtics auto
set xtics .05
set xlabel '10^3 gap q_2'
plot rows('gap', '1') using (1e3*$3):4 with lines title 'midpoint rule, 3200 points per length'
