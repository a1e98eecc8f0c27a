# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot charged_fibers.gnuplot in the folder with charged_fibers.csv draws charged_fibers.png.

set terminal pngcairo size 1200,900 font 'sans,11'
set output 'charged_fibers.png'
set datafile separator ','
set grid
set key font ',9'
rows(configuration, potential, method) = \
  sprintf("< grep '^%s,%s,%s,' charged_fibers.csv", configuration, potential, method)
set multiplot layout 2,2 title 'Charges on rings (SSIP Fig. 11) and cylinders of 50 radii (SSIP Fig. 12)'
set logscale x
set format x '10^{%T}'
set xlabel 'g/R'
set ylabel 'energy'
set y2label 'relative error of the energy'
set ytics nomirror
set y2tics
set logscale y2
set format y2 '10^{%T}'
do for [case in "'parallel rings' 'perpendicular rings' 'parallel charged cylinders' 'perpendicular charged cylinders'"] {
  monopole = case[strlen(case)-4:] eq 'rings' ? 'monopole' : 'monopole,64 elements'
  set title case
  plot rows(case, 'Coulomb', 'reduction') using 5:8 with lines linewidth 4 \
         linecolor rgb 'gray' title 'exact', \
       rows(case, 'Coulomb', monopole) using 5:8 with linespoints \
         linecolor 1 title 'monopole', \
       rows(case, 'Coulomb', monopole) using 5:(abs($10)) axes x1y2 \
         with linespoints linecolor 2 title 'its error (right)'
}
