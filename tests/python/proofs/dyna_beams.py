"""Beams that touch, sections by rules of integration, and beams without strength."""

import math

from . import FIRST, LAST, Proof
from .pieces import DENSITY, cube, deck, elastic, node_set, nodes, part, shell_section, square

LENGTH, SPEED = 6.0, 1000.0  # of the beam that falls
HELD = node_set(1, *range(1, 9)) + "*BOUNDARY_SPC_SET\n1,0,1,1,1\n"
PAIR = "*CONTACT_AUTOMATIC_BEAMS_TO_SURFACE\n2,1,3,3\n\n\n"
ROUND = "*SECTION_BEAM\n2,1,1.0,2,1\n1.0,1.0\n"
FALLS = node_set(6, 21, 22) + f"*INITIAL_VELOCITY\n6\n0,0,{-SPEED}\n"


def fall(contact, section=ROUND, *more, end=1.2e-3, law=2, word="*PART\n", line=""):
    """A beam falls at 1 mm/ms on the top of a held cube, which is at 10 mm; its axis begins at 11.5 mm. Its two nodes have no waves: both stop where it touches."""
    body = nodes((21, 2.0, 5.0, 11.5), (22, 2.0 + LENGTH, 5.0, 11.5), (23, 2.0, 5.0, 30.0)) + "*ELEMENT_BEAM\n9,2,21,22,23\n"
    return deck(cube(), HELD, body, f"{word}beam\n2,2,{law}\n{line}", section, elastic(2), FALLS, contact, *more, "*DATABASE_HISTORY_NODE\n21,22\n", end=end)


def rests(radius):
    """Where the axis comes to rest, and that all of the momentum is gone."""
    return [("node_21_z", LAST, 10.0 + radius, 1e-5), ("node_22_z", LAST, 10.0 + radius, 1e-5), ("momentum_z", LAST, 0.0, 1e-12)]


def passes(area=math.pi / 4):
    return [("momentum_z", LAST, -SPEED * DENSITY * area * LENGTH, 1e-9)]


def cross(contact, *more):
    """A beam of diameter 1 falls across the middle of another; both are free, and one element each: they go on together at half the speed, or pass."""
    body = nodes((21, 0.0, 5.0, 2.0), (22, 10.0, 5.0, 2.0), (24, 5.0, 0.0, 0.0), (25, 5.0, 10.0, 0.0)) + "*ELEMENT_BEAM\n9,2,21,22,0\n10,3,24,25,0\n"
    return deck(body, part(2, 2, 2), part(3, 2, 2), ROUND, elastic(2), FALLS, contact, *more, "*DATABASE_HISTORY_NODE\n21,24\n", end=2.5e-3)


TOGETHER = [(lambda h: h["node_21_z"][-1] - h["node_24_z"][-1], LAST, 1.0, 1e-4), ("node_24_z", LAST, -0.5 * SPEED * 1.5e-3, 1e-2)]
APART = [(lambda h: h["node_21_z"][-1] - h["node_24_z"][-1], LAST, 2.0 - SPEED * 2.5e-3, 1e-6)]
SINGLE = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0\n"
GENERAL = "*CONTACT_AUTOMATIC_GENERAL\n0\n0\n"
SETS = "*SET_PART_LIST\n7\n1,2\n*SET_PART_LIST\n8\n2,3\n"


def ruled(lines):
    return fall(PAIR, "*SECTION_BEAM\n2,1,1.0,-7,0\n0,0\n" + lines)


def momentum(area):
    return ("momentum_z", FIRST, -SPEED * DENSITY * area * LENGTH, 1e-9)


def edged(contact, *more):
    """A sheet with a beam of no strength on an edge, of density 5e-9 and diameter 2, falls on a held cube; the mass of the beam is its nodes'."""
    sheet = square(3, 31, (2.0, 2.0, 12.0), 6.0, of=3) + part(3, 3) + shell_section(3, 0.5)
    line = "*ELEMENT_BEAM\n9,2,31,32,0\n" + part(2, 2, 5) + "*SECTION_BEAM\n2,1,1.0,2,1\n2.0,2.0\n*MAT_NULL\n5,5e-9\n"
    falls = node_set(6, 31, 32, 33, 34) + f"*INITIAL_VELOCITY\n6\n0,0,{-SPEED}\n"
    return deck(cube(), HELD, sheet, line, falls, contact, *more, "*DATABASE_HISTORY_NODE\n31\n", end=3e-3)


SHEET_MASS, LINE_MASS = DENSITY * 36.0 * 0.5, 5e-9 * math.pi * LENGTH

PROOFS = [
    Proof("CONTACT_AUTOMATIC_BEAMS_TO_SURFACE; CONTACT: SSID MSID SSTYP MSTYP", fall(PAIR), rests(0.5), "a round beam of diameter 1 lies on the cube: TS1 of CST 1"),
    Proof("SECTION_BEAM: CST TS1", fall(PAIR, "*SECTION_BEAM\n2,1,1.0,2,0\n1.2,1.2,3.0,3.0\n"), rests(0.6), "of a rectangle the diameter of contact is TS1"),
    Proof("SECTION_BEAM: TS1", fall(PAIR, "*SECTION_BEAM\n2,9,1.0,2,1\n1e-308\n"), refused="too small for a number of its area"),
    Proof("SECTION_BEAM: A", fall(PAIR, "*SECTION_BEAM\n2,3\n4.0\n"), rests(1.0), "of a truss it is the root of the area"),
    Proof("SECTION_BEAM: A", fall(PAIR, "*SECTION_BEAM\n2,2\n1.44,1.0,1.0,1.0,1.0\n"), rests(0.6), "of resultants, too"),
    Proof("CONTACT: SST", fall("*CONTACT_AUTOMATIC_BEAMS_TO_SURFACE\n2,1,3,3\n\n0,0,1.4\n"), rests(0.7), "SST is the diameter of contact"),
    Proof("CONTACT: SFST", fall("*CONTACT_AUTOMATIC_BEAMS_TO_SURFACE\n2,1,3,3\n\n0,0,0,0,1.6\n"), rests(0.8), "or SFST of TS1"),
    Proof("CONTACT: MST SFMT", fall("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n\n0,0,0,1.4\n"), rests(0.7), "MST of side M"),
    Proof("PART_CONTACT: OPTT", fall(PAIR, word="*PART_CONTACT\n", line="0,0,0,0,1.4\n"), rests(0.7), "OPTT is the diameter of contact"),
    Proof("CONTACT: SST", fall("*CONTACT_AUTOMATIC_BEAMS_TO_SURFACE\n2,1,3,3\n\n0,0,1.4\n" + PAIR), refused="in another contact"),
    Proof("CONTACT_AUTOMATIC_NODES_TO_SURFACE; CONTACT: SSTYP", fall("*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n9,1,4,3\n\n\n", ROUND, node_set(9, 21, 22)), rests(0.5), "nodes of the beam"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE; CONTACT: MSTYP", fall("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n\n\n"), rests(0.5), "the beam is side M"),
    Proof("CONTACT_AUTOMATIC_SINGLE_SURFACE; CONTACT: SSID", fall(SINGLE + "\n"), rests(0.5), "beams are part of everything"),
    Proof("CONTACT_AUTOMATIC_SINGLE_SURFACE; CONTACT: SSID SSTYP", fall("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n7,0,2\n0\n\n", ROUND, SETS), rests(0.5), "and of a set of parts"),
    Proof("CONTACT_AUTOMATIC_GENERAL; CONTACT: SSID", fall(GENERAL + "\n"), rests(0.5), "everything"),
    Proof("CONTACT_AUTOMATIC_SINGLE_SURFACE; CONTACT: SSID SSTYP", fall("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,0,3\n0\n\n"), passes(), "the cube alone: the beam falls through it"),
    Proof("CONTACT_AUTOMATIC_GENERAL; CONTACT: SSID", cross(GENERAL + "\n"), TOGETHER, "beams touch along their length; two of one mass go on together"),
    Proof("CONTACT_AUTOMATIC_GENERAL; CONTACT: SSID SSTYP", cross("*CONTACT_AUTOMATIC_GENERAL\n8,0,2\n0\n\n", SETS), TOGETHER, "likewise, of a set of parts"),
    Proof("CONTACT_AUTOMATIC_SINGLE_SURFACE", cross("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n8,0,2\n0\n\n", SETS), APART, "here they do not: they pass"),
    Proof("CONTACT_AUTOMATIC_SINGLE_SURFACE", fall(SINGLE + "\n").replace("*MAT_ELASTIC\n2,", "*MAT_SPOTWELD\n2,").replace("0.3\n*SET", "0.3,1e5,0\n0\n*SET"), passes(), "beams of a spot weld touch nothing"),
    Proof("INTEGRATION_BEAM: IRID ICST D1", ruled("*INTEGRATION_BEAM\n7,0,0.0,8\n0.6\n"), [momentum(math.pi * 0.36), *rests(0.6)], "a circle of radius D1"),
    Proof("INTEGRATION_BEAM: ICST D1 D2", ruled("*INTEGRATION_BEAM\n7,0,0.0,9\n0.6,0.5\n"), [momentum(math.pi * 0.11), *rests(0.6)], "a tube of the radii D1 and D2"),
    Proof("INTEGRATION_BEAM: ICST D1 D2", ruled("*INTEGRATION_BEAM\n7,0,0.0,11\n1.2,3.0\n"), [momentum(3.6), *rests(0.6)], "a rectangle D1 by D2"),
    Proof("INTEGRATION_BEAM: ICST", ruled("*INTEGRATION_BEAM\n7,0,0.0,2\n1.2,3.0,0.1,0.1\n"), refused="ICST 2 (channel)"),
    Proof("INTEGRATION_BEAM: NIP RA", ruled("*INTEGRATION_BEAM\n7,1,1.0,0\n0.0,0.0,1.0\n"), refused="points of its own"),
    Proof("INTEGRATION_BEAM: SREF TREF", ruled("*INTEGRATION_BEAM\n7,0,0.0,8\n0.6,0,0,0,1.0,0\n"), refused="in the middle of the section"),
    Proof("MAT_NULL: RO", edged("*SET_PART_LIST\n7\n1,2,3\n*CONTACT_AUTOMATIC_GENERAL\n7,0,2\n0\n\n"),
          [("momentum_z", FIRST, -SPEED * (SHEET_MASS + LINE_MASS), 1e-9), (lambda h: min(h["node_31_z"]), LAST, 10.25, 2e-2)],
          "a beam without strength on the edge of a sheet: the sheet comes down to half its thickness, and springs throw it back"),
    Proof("MAT_NULL", fall(PAIR, law=3).replace("*CONTACT", "*MAT_NULL\n3,7.8e-9\n*CONTACT", 1), refused="without strength"),
]  # fmt: skip
