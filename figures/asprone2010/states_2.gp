# Beside Figure 2: where the error of the displacement lies.
y_column = "error_displacement"; y_label = "|u − exact|"; mark = "(45) with "
heading(of_comment) = "Static test: error of the displacement at each particle, " . of_comment
load "figures/asprone2010/states.gp"
