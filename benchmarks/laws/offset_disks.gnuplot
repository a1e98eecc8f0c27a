# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot offset_disks.gnuplot in the folder with offset_disks.csv draws offset_disks.png.

set terminal pngcairo size 1200,480 font 'sans,11'
set output 'offset_disks.png'
set datafile separator ','
set grid
set multiplot layout 1,2 title 'Two disks in parallel planes, Lennard-Jones (ISSIP Fig. 4)'
rows(method, offset) = sprintf( \
  "< awk -F, '$3 == \"%s\" && $7 == %g' offset_disks.csv", method, offset)

set xlabel 'gap q_2'
set ylabel 'energy per length^2'
array offsets[4] = [0, 2e-4, 5e-4, 1e-3]
set key bottom right
plot for [i=1:4] rows('2D reduction', offsets[i]) using 5:8 with lines \
       linewidth 3 linecolor i title sprintf('exact, offset %g', offsets[i]), \
     for [i=1:4] rows('offset-disks', offsets[i]) using 5:8 with points \
       pointtype 6 linecolor i title sprintf('ISSIP, %g', offsets[i])

set logscale y
set format y '10^{%T}'
set key top left
set xlabel 'offset q_1'
set ylabel 'largest relative error of the energy over the gaps'
largest(method) = sprintf("< awk -F, '$3 == \"%s\" {e = $10 < 0 ? -$10 : $10; if (e > m[$7]) m[$7] = e} END {for (o in m) print o \",\" m[o]}' offset_disks.csv | sort -g", method)
plot largest('disk-disk') using 1:2 with linespoints title 'SSIP', \
     largest('offset-disks') using 1:2 with linespoints title 'ISSIP'
