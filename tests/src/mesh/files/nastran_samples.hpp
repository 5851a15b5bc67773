#pragma once
// The two unit cubes of sample_files.hpp with a shell on the far end, as Nastran bulk data: in short fields, in long
// ones and between commas. All three are one mesh.

#include <string>

namespace percuss::testing_mesh {

inline const std::string nastran_short = R"(SOL 101
$HMSET        4        1 "corner" 18
SET 4 = 10,
  120
SET 9 = 1.5, 2.5
CEND
TITLE = two cubes, joined
BEGIN BULK
$HMNAME PROP                   1"left" 5
$HMNAME COMP                   3"cap"
$ 345678 2345678 2345678
GRID          10             0.0     0.0     0.0
GRID          20             0.0     1.0     0.0
GRID          30               0      1.    1.D0        $ a remark
GRID          40             0.0     0.0     1.0
GRID          50              1.     0.0     0.0
GRID          60              1.      1.     0.0
GRID          70              1.      1.  10.0-1
GRID          80              1.     0.0      1.
GRID          90              2.     0.0     0.0
GRID         100              2.     1.0     0.0
GRID         110              2.     1.0     1.0
GRID         120              2.     0.0     1.0
CHEXA          3       1      10      50      60      20      40      80+A
+A            70      30
CHEXA          4       2      50      90     100      60      80     120
             110      70
CTRIA3         5       3      90     100     110
CTRIA3         6       3      90     110     120
                            0.25     0.5
SET1           5      20    THRU      40      10
SET1           6       5
SET3           8    PROP       1       2
PSOLID         1       1
$ FEMAP Property 2 : right side
PSOLID         2       1
PSHELL         3       1     0.5
MAT1           1  2.0E11             0.3   7850.
ENDDATA
not read
)";

/// In system 7 x runs along -y of the mesh, and y along its x.
inline const std::string nastran_long = R"($ no executive control
cord2r*                7               0             0.0             0.0*
*                    0.0             0.0             0.0             1.0*
*                    0.0            -1.0             0.0
GRID*                 10               7             0.0             0.0*C1
*C1                  0.0
GRID*                 20               7            -1.0             0.0
*                    0.0
GRID*                 30               7            -1.0             0.0
*                    1.0
GRID*                 40                             0.0             0.0
*                    1.0
GRID*                 50                             1.0             0.0

*                    0.0
grid*                 60                             1.0           1.0D0
*                    0.0
GRID*                 70                             1.0             1.0
$ a remark between the lines
*                    1.0
GRID*                 80                             1.0             0.0
*                    1.0
GRID*                 90                             2.0             0.0
*                    0.0
GRID*                100                             2.0             1.0
*                    0.0
GRID*                110                             2.0             1.0
*                    1.0
GRID*                120                             2.0             0.0
*                    1.0
$ Elements and Element Properties for region : left
PSOLID*                1               1
CHEXA*                 3               1              10              50*B1
*B1                   60              20              40              80*B2
*B2                   70              30
$*  Property: right side
PSOLID*                2               1
CHEXA*                 4               2              50              90
*                    100              60              80             120
*                    110              70
$ANSA_NAME_COMMENT;3;PSHELL;cap;;NO;NO;NO;NO;
CTRIA3*                5               3              90             100
*                    110
CTRIA3*                6               3              90             110
*                    120
*                                                   0.25             0.5
PSHELL*                3               1             0.5
)";

inline const std::string nastran_free =
    "BEGIN BULK\n"
    "GRDSET,,7\n"
    "CORD2C,7,,0,0,0,0,0,1\n"
    ",1.,0.,0.\n"
    "GRID,10,0,0.,0.,0.\n"
    "GRID,20,,1.,90.,0.\n"
    "GRID,30,,1.,90.,1.\n"
    "GRID,40,,0.,45.,1.\n"
    "GRID,50,,1.,0.,0.\n"
    "GRID,60,0,1.,1.\n"
    "GRID,70,0,1.,1.,1.\n"
    "GRID*,80,,1.,-360.\n"
    "*,1.\n"
    "GRID\t90\t0\t2.\t0.\t0.\n"
    "GRID,100,0,2.,1.,0.\n"
    "GRID,110,0,2.,1.,1.\n"
    "GRID,120,0,2.,0.,1.\n"
    "CHEXA,3,1,10,50,60,20,40,80,+X\n"
    "+X,70,30\n"
    "CHEXA,4,2,50,90,100,60,80,120\n"
    "+,110,70\n"
    "CTRIA3,5,3,90,100,110\n"
    "CTRIA3,6,3,90,110,120\n"
    ",,1,0.5,1.0\n"
    "CBAR,7,4,90,110,0.,0.,1.\n"
    "CONM2,8,120,,3.0\n"
    "PSHELL,3,1,0.5\n"
    "$ANSA_NAME;1;PSOLID;~\n"
    "$left\n"
    "PSOLID,1,1\n"
    "SET,4,ELEM,LIST\n"
    "+,3,THRU,5,8\n"
    "$HMSET 4 2 \"some\" 18\n"
    "ENDDATA\n";

/// One tetrahedron of ten nodes.
inline const std::string nastran_of_ten = R"(BEGIN BULK
GRID,1,,0.,0.,0.
GRID,2,,2.,0.,0.
GRID,3,,0.,2.,0.
GRID,4,,0.,0.,2.
GRID,5,,1.,0.,0.
GRID,6,,1.,1.,0.
GRID,7,,0.,1.,0.
GRID,8,,0.,0.,1.
GRID,9,,1.,0.,1.
GRID,10,,0.,1.,1.
CTETRA,2,7,1,2,3,4,5,6
,7,8,9,10
ENDDATA
)";

}  // namespace percuss::testing_mesh
