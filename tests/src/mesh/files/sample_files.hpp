#pragma once
// Two unit cubes in a row along x with a shell on the far end, as text formats write them: twelve nodes, ids with gaps.

#include <cstdint>
#include <cstring>
#include <string>

namespace percuss::testing_mesh {

inline const std::string gmsh_22 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
4
0 9 "tip"
2 3 "near side"
2 4 "cap"
3 1 "left"
$EndPhysicalNames
$Nodes
13
10 0 0 0
20 0 1 0
30 0 1 1
40 0 0 1
50 1 0 0
60 1 1 0
70 1 1 1
80 1 0 1
90 2 0 0
100 2 1 0
110 2 1 1
120 2 0 1
5000000000 9 9 9
$EndNodes
$Elements
6
1 15 2 9 1 120
2 3 2 3 1 10 20 30 40
3 5 2 1 1 10 50 60 20 40 80 70 30
4 5 2 2 2 50 90 100 60 80 120 110 70
5 2 2 4 7 90 100 110
6 2 2 4 7 90 110 120
$EndElements
)";

/// The cap stands off the cubes, so that it is no face of them.
inline const std::string gmsh_41 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
2 4 "cap"
3 1 "left"
$EndPhysicalNames
$Entities
1 0 2 2
7 0 0 0 1 9
1 0 0 0 0 1 1 1 3 0
2 5 0 0 5 1 1 1 4 0
1 0 0 0 1 1 1 2 1 8 0
2 1 0 0 2 1 1 0 0
$EndEntities
$Nodes
2 15 1 700
3 1 0 12
10 20 30 40 50 60 70 80 90 100 110 120
0 0 0
0 1 0
0 1 1
0 0 1
1 0 0
1 1 0
1 1 1
1 0 1
2 0 0
2 1 0
2 1 1
2 0 1
2 2 1 3
500 600 700
5 0 0 0.1 0.2
5 1 0 0.1 0.2
5 1 1 0.1 0.2
$EndNodes
$Elements
5 5 1 6
0 7 15 1
1 120
2 1 3 1
2 10 20 30 40
2 2 2 1
5 500 600 700
3 1 5 1
3 10 50 60 20 40 80 70 30
3 2 5 1
4 50 90 100 60 80 120 110 70
$EndElements
)";

inline const std::string keyword_deck = R"($ two cubes and a shell
*KEYWORD
*TITLE
cubes, joined
*PART
left
         1         1         1
right side
         2         1         1
cap
         3         2         1
*NODE
      10             0.0             0.0             0.0       0       0
      20             0.0             1.0             0.0
      30             0.0             1.0           1.0D0
      40             0.0             0.0             1.0
50, 1., 0., 0.
60, 1., 1., 0.
70, 1., 1., 10.-1
80, 1., 0., 1.
*NODE%
        90             2.0             0.0             0.0
       100             2.0             1.0             0.0
       110             2.0             1.0             1.0
       120             2.0             0.0             1.0
*ELEMENT_SOLID a remark
       7       1      10      50      60      20      40      80      70      30
       8       2
      50      90     100      60      80     120     110      70
*ELEMENT_SHELL
       7       3      90     100     110     110
       9       3      90     110     120       0
*SET_NODE_LIST_TITLE
corner
         4
        10       120
*SET_NODE_GENERATE
         5
        15        45
*SET_SHELL_LIST
         6
         7
*SET_PART_LIST
         8
         1         2
*SET_SEGMENT
         9
        10        20        30        40
*MAT_ELASTIC
         1    7850.0   2.0E11       0.3
*END
not read
)";

inline const std::string abaqus_input = R"(*HEADING
** two cubes and a shell
joined cubes
*PART, NAME=bar
*Node, nset = All
 10, 0., 0., 0.
 20, 0., 1.
 30, 0., 1., 1.
 40, 0., 0., 1.
 50, 1., 0., 0.
 60, 1., 1., 0.
 70, 1., 1., 1.
 80, 1., 0., 1.
 90, 2., 0., 0.
 100, 2., 1., 0.
 110, 2., 1., 1.
 120, 2., 0., 1.
*ELEMENT, TYPE=c3d8r, ELSET=left
 3, 10, 50, 60, 20, 40,
 80, 70, 30
*ELEMENT, TYPE=C3D8R,
 ELSET=right
 4, 50, 90, 100, 60, 80, 120, 110, 70
*ELEMENT, TYPE=S3, ELSET=cap
 5, 90, 100, 110
 6, 90, 110, 120
*ELEMENT, TYPE=B31, ELSET=wire
 7, 90, 110
*NSET, NSET=ends, GENERATE
 10, 40, 10
*NSET, NSET=more
 ENDS, 120
*ELSET, ELSET=half of it
 3, 5
*SURFACE, NAME=near, TYPE=ELEMENT
 LEFT, S6
*SURFACE, NAME=outside
 cap, SPOS
 4, S2
*END PART
*ASSEMBLY, NAME=all
*INSTANCE, NAME=bar-1, PART=bar
*END INSTANCE
*NSET, NSET=tip, INSTANCE=bar-1
 120
*END ASSEMBLY
*MATERIAL, NAME=steel
*DENSITY
 7850.
)";

/// One tetrahedron of ten nodes, with a side: by its three corners and three middles, and by its triangles.
inline const std::string gmsh_of_ten = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
10
1 0 0 0
2 2 0 0
3 0 2 0
4 0 0 2
5 1 0 0
6 1 1 0
7 0 1 0
8 0 0 1
9 1 0 1
10 0 1 1
$EndNodes
$Elements
2
1 9 2 3 1 1 3 2 7 6 5
2 11 2 7 1 1 2 3 4 5 6 7 8 10 9
$EndElements
)";
inline const std::string keyword_of_ten = R"(*KEYWORD
*NODE
1, 0., 0., 0.
2, 2., 0., 0.
3, 0., 2., 0.
4, 0., 0., 2.
5, 1., 0., 0.
6, 1., 1., 0.
7, 0., 1., 0.
8, 0., 0., 1.
9, 1., 0., 1.
10, 0., 1., 1.
*ELEMENT_SOLID
2, 7
1, 2, 3, 4, 5, 6, 7, 8, 9, 10
*SET_SEGMENT
3
1, 7, 5, 5
7, 3, 6, 6
5, 6, 2, 2
5, 7, 6, 6
*END
)";

template <class T>
void append_bytes(std::string& text, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  text.append(bytes, sizeof(T));
}

/// One cube of version 2.2 or 4.1 in binary.
inline std::string make_binary_gmsh(bool is_41) {
  constexpr double places[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  std::string text = is_41 ? "$MeshFormat\n4.1 1 8\n" : "$MeshFormat\n2.2 1 8\n";
  append_bytes(text, 1);
  text += "\n$EndMeshFormat\n$Nodes\n";
  if (is_41) {
    for (const std::uint64_t value : {1, 8, 1, 8}) append_bytes(text, value);
    for (const int value : {3, 1, 0}) append_bytes(text, value);
    append_bytes(text, std::uint64_t{8});
    for (std::uint64_t id = 1; id <= 8; ++id) append_bytes(text, id);
  } else {
    text += "8\n";
  }
  for (int n = 0; n < 8; ++n) {
    if (!is_41) append_bytes(text, n + 1);
    for (const double x : places[n]) append_bytes(text, x);
  }
  text += "\n$EndNodes\n$Elements\n";
  if (is_41) {
    for (const std::uint64_t value : {1, 1, 1, 1}) append_bytes(text, value);
    for (const int value : {3, 1, 5}) append_bytes(text, value);
    append_bytes(text, std::uint64_t{1});
    for (std::uint64_t value = 1; value <= 9; ++value) append_bytes(text, value == 1 ? std::uint64_t{77} : value - 1);
  } else {
    text += "1\n";
    for (const int value : {5, 1, 2, 77, 6, 6, 1, 2, 3, 4, 5, 6, 7, 8}) append_bytes(text, value);
  }
  return text + "\n$EndElements\n";
}

}  // namespace percuss::testing_mesh
