# Beside Figure 2: where the error of the displacement lies.
y_column = "error_displacement"; y_label = "|u − u exact|"
heading() = "Static test: error of the displacement at each particle, " . comment("(45) with ")
load "figures/asprone2010/states.gp"
