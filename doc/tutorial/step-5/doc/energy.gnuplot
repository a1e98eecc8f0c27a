# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 The Setae authors
#
# gnuplot -e "conserving='DIR'; trapezoidal='DIR'; damped='DIR'" energy.gnuplot
# draws energy.png from the statistics of three runs of prm/snap.prm:
# energy-conserving and generalized-alpha with rho infinity = 1, and
# generalized-alpha with 0.9.

set terminal pngcairo size 1100,420 font 'sans,10'
set output 'energy.png'
set grid
set xlabel 'time'
set key below horizontal

# The column of a name in the header of the statistics.
column_of(dir, name) = int(system("sed -n 's/^# \\([0-9]*\\): ".name."$/\\1/p' ".dir."/statistics.txt"))
file(dir) = dir.'/statistics.txt'

kinetic = column_of(conserving, 'kinetic energy')
strain = column_of(conserving, 'strain energy')
attraction = column_of(conserving, 'interaction (coulomb) energy')
contact = column_of(conserving, 'interaction (contact) energy')
total_1 = column_of(conserving, 'total energy')
total_2 = column_of(trapezoidal, 'total energy')
total_3 = column_of(damped, 'total energy')

set multiplot layout 1,2
set title 'energy-conserving steps'
set ylabel 'energy'
plot file(conserving) using 2:kinetic every 10 with lines title 'kinetic', \
     file(conserving) using 2:strain every 10 with lines title 'strain', \
     file(conserving) using 2:attraction every 10 with lines title 'attraction', \
     file(conserving) using 2:contact every 10 with lines title 'contact', \
     file(conserving) using 2:total_1 every 10 with lines linewidth 2 title 'total'
set title 'loss of total energy since the end of the ramp'
set ylabel 'percent'
E0 = -0.14454
set xrange [1e-3:]
plot file(conserving) using 2:(100*(column(total_1)/E0-1)) every 10 with lines linewidth 2 title 'energy-conserving', \
     file(trapezoidal) using 2:(100*(column(total_2)/E0-1)) every 10 with lines title 'generalized-alpha, {/Symbol r} = 1', \
     file(damped) using 2:(100*(column(total_3)/E0-1)) every 10 with lines title '{/Symbol r} = 0.9'
