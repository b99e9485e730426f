# A mesh of FreeFem++ as one of Gmsh. The names of the sides, in the order of their labels, are given by -v names="A B C".
BEGIN {
    n = split(names, name)
    printf "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n%d\n", n + 1
    for (k = 1; k <= n; ++k) printf "1 %d \"%s\"\n", k, name[k]
    printf "2 %d \"body\"\n$EndPhysicalNames\n", n + 1
}
NR == 1 { places = $1; triangles = $2; sides = $3; print "$Nodes"; print places; next }
NR <= 1 + places { print NR - 1, $1, $2, 0; next }
NR == 2 + places { print "$EndNodes"; print "$Elements"; print triangles + sides }
NR <= 1 + places + triangles { print NR - 1 - places, 2, 2, n + 1, n + 1, $1, $2, $3; next }
{ print NR - 1 - places, 1, 2, $3, $3, $1, $2 }
END { print "$EndElements" }
