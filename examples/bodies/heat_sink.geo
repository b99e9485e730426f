// The cross-section of a heat sink: fins on a plate whose lower side is heated. Lengths in metres.
fins = 5;
height = 0.03;      // of a fin above the plate
thickness = 0.002;  // of a fin
gap = 0.006;        // between fins
plate = 0.005;      // thickness of the plate

pitch = thickness + gap;
width = fins * pitch - gap;
points[] = {};
For fin In {fins - 1 : 0 : -1}
    right = fin * pitch + thickness;
    If (fin < fins - 1)
        points[] += newp; Point(newp) = {right + gap, plate, 0};
        points[] += newp; Point(newp) = {right, plate, 0};
    EndIf
    points[] += newp; Point(newp) = {right, plate + height, 0};
    points[] += newp; Point(newp) = {right - thickness, plate + height, 0};
EndFor
points[] += newp; Point(newp) = {0, 0, 0};
points[] += newp; Point(newp) = {width, 0, 0};

curves[] = {};
count = #points[];
For k In {0 : count - 1}
    curves[] += newc; Line(newc) = {points[k], points[(k + 1) % count]};
EndFor
Curve Loop(1) = curves[];
Plane Surface(1) = {1};

Physical Curve("base") = {curves[count - 2]};
Physical Curve("fins") = {curves[{0 : count - 3}], curves[count - 1]};
Physical Surface("sink") = {1};

Mesh.MeshSizeMax = 0.0005;
