"""Rolled sheet of keyword decks: *MAT_036, 037 and 122."""

import math

from . import LAST, Proof
from .dyna_composites import PLAIN, strained, with_option
from .pieces import curve, deck, hexahedron, part, solid_section
from .sheets import barlat, barlat_by_strain, hill_by_strain, strain

E = (8e-3, -1e-3, 5e-3)  # strains xx, yy, 2 xy: some twenty times that of the first yield
MODULUS, NU = 7e4, 0.33
R = (0.7, 0.5, 1.6)
TOLERANCE = 1e-2  # the strains of the element are nominal ones
AXIS = "0,0,0,0.8,0.6,0\n"  # A, at 36.87 degrees
AT = math.degrees(math.atan2(0.6, 0.8))


def pulled(material, *more, shells=""):
    return strained(part(1, 1, 2), f"*SECTION_SHELL\n1,2,1.0,5{PLAIN}\n", material, *more, e=E, k=0.0, shells=shells)


def m36(head="1.0,500.0,40.0", ratios="2.0,0.7,0.5,1.6", more="", options="2.0", point=AXIS, vectors="0\n", name="MAT_3-PARAMETER_BARLAT"):
    return f"*{name}\n2,2.7e-9,{MODULUS},{NU},{head}\n{ratios}{more}\n{options}\n{point}{vectors}"


def m122(head="1.0,500.0,40.0", more="", options="2.0", point=AXIS, vectors="0\n"):
    return f"*MAT_HILL_3R\n2,2.7e-9,{MODULUS},{NU},{head}\n0.7,0.5,1.6{more}\n{options}\n{point}{vectors}"


def m37(more):
    return f"*MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC\n2,2.7e-9,{MODULUS},{NU},{more}\n"


def line(stress=40.0, slope=500.0):
    return lambda p: stress + MODULUS * slope / (MODULUS - slope) * p


def swift(k, e0, n):
    return lambda p: k * (e0 + p) ** n


def work(surface, hardening, degrees=AT, **more):
    return [("internal", LAST, 100.0 * strain(surface, hardening, MODULUS, NU, E, degrees, **more), TOLERANCE)]


HILL = hill_by_strain(*R)
ROWS = curve(9, (0.0, 30.0), (0.005, 60.0), (0.1, 90.0))


def rows(p):
    return 30 + 6000 * p if p < 0.005 else 60 + 30 * (p - 0.005) / 0.095


def rated(strain_of_all):
    """Cowper and Symonds with 60 / s and 4, in the 1 ms of the rows."""
    return 1 + (strain_of_all / 1e-3 / 60.0) ** 0.25


PROOFS = [
    Proof("MAT_3-PARAMETER_BARLAT: MID RO E PR HR P1 P2 M R00 R45 R90 AOPT A1 A2 A3", pulled(m36()), work(HILL, line()), "Hill's surface"),
    Proof("MAT_3-PARAMETER_BARLAT: M R00 R45 R90", pulled(m36(ratios="8.0,0.7,0.5,1.6")), work(barlat_by_strain(*R, 8.0), line()), "that of Barlat and Lian"),
    Proof("MAT_3-PARAMETER_BARLAT: R00 R45 R90 PB", pulled(m36(ratios="6.0,1.1,0.9,1.15", options="2.0,0,0,0,0,0.95")), work(barlat(0.9, 1.15, 0.95, 6.0), line()), "by a, c, h and p"),
    Proof("MAT_3-PARAMETER_BARLAT: HR P1 P2 E0", pulled(m36("2.0,150.0,0.2", more=",0,0.004")), work(HILL, swift(150.0, 0.004, 0.2)), "Swift's hardening"),
    Proof("MAT_3-PARAMETER_BARLAT: SPI", pulled(m36("2.0,150.0,0.2", more=",0,0,0.002")), work(HILL, swift(150.0, 0.002, 0.2)), "the first strain by SPI"),
    Proof("MAT_3-PARAMETER_BARLAT: SPI", pulled(m36("2.0,150.0,0.2", more=",0,0,50.0")), work(HILL, swift(150.0, (50.0 / 150.0) ** 5, 0.2)), "the first stress by SPI"),
    Proof("MAT_3-PARAMETER_BARLAT: SPI", pulled(m36("2.0,150.0,0.2")), work(HILL, swift(150.0, (MODULUS / 150.0) ** (1 / -0.8), 0.2)), "the curve begins on the elastic line"),
    Proof("MAT_3-PARAMETER_BARLAT: LCID", pulled(m36("3.0", more=",9"), ROWS), work(HILL, rows), "a curve"),
    Proof("MAT_3-PARAMETER_BARLAT: AOPT BETA", pulled(m36(options="0.0", vectors="0,0,0,0,0,0,25.0\n")), work(HILL, line(), 25.0), "turned from the first side"),
    Proof("MAT_3-PARAMETER_BARLAT: AOPT V1 V2 V3", pulled(m36(options="3.0", vectors="0.6,0.8,0\n")), work(HILL, line(), -AT), "V x n = (0.8, -0.6)"),
    Proof("ELEMENT_SHELL_BETA: BETA", pulled(m36(), shells=with_option("BETA", "1.0,1.0,1.0,1.0,20.0\n")), work(HILL, line(), AT + 20.0), "turned from A"),
    Proof("MAT_3-PARAMETER_BARLAT: C P", pulled(m36(options="2.0,60.0,4.0")), work(HILL, line(), rate=rated), "Cowper and Symonds"),
    Proof("MAT_3-PARAMETER_BARLAT: P2", pulled(m36("2.0,150.0,1.2")), refused="an exponent below 1"),
    Proof("MAT_3-PARAMETER_BARLAT: HR", pulled(m36("4.0,150.0,50.0")), refused="HR = 4"),
    Proof("MAT_3-PARAMETER_BARLAT: M", pulled(m36(ratios="1.0,0.7,0.5,1.6")), refused="an exponent from 2 to 40"),
    Proof("MAT_3-PARAMETER_BARLAT: R00", pulled(m36(ratios="2.0,-9.0,0.5,1.6")), refused="a negative one is a curve"),
    Proof("MAT_3-PARAMETER_BARLAT: R00 R45", pulled(m36(ratios="6.0,1.0,0.9,1.15", options="2.0,0,0,0,0,0.95")), refused="AB + CB = 1.9"),
    Proof("MAT_3-PARAMETER_BARLAT", deck(hexahedron(), part(1, 1, 2), solid_section(), m36()), refused="elements other than shells"),
    Proof("MAT_HILL_3R: MID RO E PR HR P1 P2 R00 R45 R90 AOPT A1 A2 A3", pulled(m122()), work(HILL, line()), "as MAT_036 with M = 2"),
    Proof("MAT_HILL_3R: E0", pulled(m122("2.0,150.0,0.2", ",0,0.004")), work(HILL, swift(150.0, 0.004, 0.2)), "Swift's hardening"),
    Proof("MAT_HILL_3R: LCID", pulled(m122("3.0", ",9"), ROWS), work(HILL, rows), "a curve"),
    Proof("MAT_HILL_3R: V1 V2 V3 BETA", pulled(m122(options="3.0", vectors="0,1.0,0,0,0,0,25.0\n")), work(HILL, line(), 25.0), "V x n = x, turned by BETA"),
    Proof("MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC: MID RO E PR SIGY ETAN R", pulled(m37("40.0,500.0,1.8")), work(hill_by_strain(1.8, 1.8, 1.8), lambda p: 40 + 500 * p), "ETAN is over plastic strain"),
    Proof("MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC: HLCID", pulled(m37("0,0,1.8,9"), ROWS), work(hill_by_strain(1.8, 1.8, 1.8), rows), "a curve"),
    Proof("MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC: R", pulled(m37("40.0,500.0,-1.8")), refused="R below 0"),
    Proof("MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC: ETAN", pulled(m37("40.0,-500.0,1.8")), refused="ETAN below 0"),
]  # fmt: skip
