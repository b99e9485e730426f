// A quarter of a strip with a circular hole in its middle, to be pulled at its end. Lengths in metres.
DefineConstant[q = {0.5, Name "hole's diameter over the strip's width"}];
half_width = 0.05;
half_length = 0.2;
radius = q * half_width;

Point(1) = {0, 0, 0};  // centre of the hole
Point(2) = {radius, 0, 0};
Point(3) = {half_length, 0, 0};
Point(4) = {half_length, half_width, 0};
Point(5) = {0, half_width, 0};
Point(6) = {0, radius, 0};
Line(1) = {2, 3};
Line(2) = {3, 4};
Line(3) = {4, 5};
Line(4) = {5, 6};
Circle(5) = {6, 1, 2};
Curve Loop(1) = {1:5};
Plane Surface(1) = {1};

Physical Curve("middle") = {1};  // the line of symmetry along the strip
Physical Curve("end") = {2};
Physical Curve("edge") = {3};
Physical Curve("neck") = {4};    // the line of symmetry across it, where the stress is largest
Physical Curve("hole") = {5};
Physical Surface("strip") = {1};

Mesh.MeshSizeMax = 0.002;
