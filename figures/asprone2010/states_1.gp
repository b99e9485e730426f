# Beside Figure 1: where the error of the second derivative lies.
y_column = "error_second"; y_label = "|D²B − B″|"; mark = " for B = "
heading(of_comment) = "Derivative test: error of D²B at each particle, B = " . of_comment
load "figures/asprone2010/states.gp"
