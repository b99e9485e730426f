// An L bracket with a fillet in its corner and a bore near its tip. Lengths in metres.
arm = 0.1;      // length of each arm
depth = 0.02;   // of an arm
fillet = 0.01;  // radius in the corner
bore = 0.005;   // radius, around (bore_x, depth / 2)
bore_x = 0.085;

inner = depth + fillet;
Point(1) = {0, 0, 0};
Point(2) = {arm, 0, 0};
Point(3) = {arm, depth, 0};
Point(4) = {inner, depth, 0};
Point(5) = {inner, inner, 0};  // centre of the fillet
Point(6) = {depth, inner, 0};
Point(7) = {depth, arm, 0};
Point(8) = {0, arm, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Circle(4) = {4, 5, 6};
Line(5) = {6, 7};
Line(6) = {7, 8};
Line(7) = {8, 1};

Point(9) = {bore_x, depth / 2, 0};  // centre of the bore
Point(10) = {bore_x + bore, depth / 2, 0};
Point(11) = {bore_x, depth / 2 + bore, 0};
Point(12) = {bore_x - bore, depth / 2, 0};
Point(13) = {bore_x, depth / 2 - bore, 0};
Circle(8) = {10, 9, 11};
Circle(9) = {11, 9, 12};
Circle(10) = {12, 9, 13};
Circle(11) = {13, 9, 10};

Curve Loop(1) = {1:7};
Curve Loop(2) = {8:11};
Plane Surface(1) = {1, 2};

Physical Curve("wall") = {7};
Physical Curve("tip") = {2};
Physical Curve("bore") = {8:11};
Physical Curve("fillet") = {4};
Physical Curve("bottom") = {1};
Physical Curve("free") = {3, 5, 6};
Physical Surface("bracket") = {1};

Mesh.MeshSizeMax = 0.002;
