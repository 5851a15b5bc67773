"""*TABLE COLLECTION with *PARAMETER TABLE: tables that user code reads by their names, in a file beside the deck."""

from ..fields import clip, parse_integer, parse_real
from ..ledger import BadInput, Place, missing
from .deck import AbaqusDeck
from .lines import Block

FILE = "parameter_tables.csv"
KINDS = {"INTEGER": "integer", "FLOAT": "float", "STRING": "string"}
INSTEAD = "it is left out"


def read_type(deck: AbaqusDeck, block: Block) -> None:
    """A line for each column: its kind, and a default that is refused."""
    kinds = []
    for line in block.lines:
        word = block.text(line, 0).upper()
        if word not in KINDS:
            raise BadInput(block.at(line[0]),
                           f"'{clip(word)}' in *{block.keyword} is none of INTEGER, FLOAT and STRING: correct it")
        if any(line[1][2:]):
            deck.ledger.refuse("PARAMETER TABLE TYPE.default", block.at(line[0]),
                               "a default of a parameter table", "a blank is 0")
        kinds.append(KINDS[word])
    wanted = parse_integer(block.option("PARAMETERS") or str(len(kinds)))
    if not kinds or wanted != len(kinds):
        raise BadInput(block.place, f"*{block.keyword} has {len(kinds)} kinds of columns "
                                    f"(PARAMETERS={clip(block.option('PARAMETERS'))}): correct one of them")
    deck.names.claim("*PARAMETER TABLE TYPE", block.option("NAME"), block.place)
    deck.parameter_tables.kinds[block.option("NAME")] = kinds
    deck.ledger.translated(block.keyword, block.place, "columns of parameter_tables")


def begin_collection(deck: AbaqusDeck, block: Block) -> None:
    deck.names.claim("*TABLE COLLECTION", block.option("NAME"), block.place)
    tables = deck.parameter_tables
    tables.lines.append(f"collection,{block.option('NAME')}")
    tables.is_open = True
    tables.places.append(block.place)


def read_table(deck: AbaqusDeck, block: Block) -> None:
    """Rows of values; one that is longer than a line goes on in the next."""
    tables = deck.parameter_tables
    if not tables.is_open:
        deck.ledger.refuse("PARAMETER TABLE.outside", block.place,
                           "a parameter table outside of a *TABLE COLLECTION", INSTEAD)
        return
    kinds = tables.kinds.get(block.option("TYPE"))
    if kinds is None:
        raise BadInput(block.place, missing(f"*PARAMETER TABLE TYPE, NAME={clip(block.option('TYPE'))}"))
    tables.lines.append(",".join(["table", block.option("LABEL") or block.option("TYPE"), *kinds]))
    lines = iter(block.lines)
    for line in lines:
        words, place = list(line[1]), block.at(line[0])
        while len(words) < len(kinds) and (more := next(lines, None)) is not None:
            words += more[1]
        tables.lines.append(",".join(["row", *read_row(place, words, kinds)]))
    deck.ledger.translated(block.keyword, block.place, "parameter_tables")


def read_row(place: Place, words: list[str], kinds: list[str]) -> list[str]:
    if len([word for word in words if word]) > len(kinds):
        raise BadInput(place, f"a row of *PARAMETER TABLE has {len(words)} values for {len(kinds)} columns: correct it")
    words = (words + [""] * len(kinds))[: len(kinds)]
    return [read_value(place, word, kind) for word, kind in zip(words, kinds)]


def read_value(place: Place, word: str, kind: str) -> str:
    """Words in capitals unless they are quoted, as Abaqus passes them."""
    if kind == "string":
        return word.strip('"') if word.startswith('"') else word.upper()
    value = (parse_integer(word) if kind == "integer" else parse_real(word)) if word else 0
    if value is None:
        raise BadInput(place, f"'{clip(word)}' in *PARAMETER TABLE is not a number of the kind {kind}: correct it")
    return repr(value)


def finish_tables(deck: AbaqusDeck) -> None:
    """The file belongs to each material of user code; without one nobody reads it."""
    tables = deck.parameter_tables
    if not tables.places:
        return
    laws = [law for law in deck.model.materials.values() if law["model"] == "user"]
    if not laws:
        for place in tables.places:
            deck.ledger.ignored("TABLE COLLECTION", place, "tables that user code reads, of which there is none")
        return
    deck.model.files[FILE] = tables.lines
    for law in laws:
        law["parameter_tables"] = FILE
    for place in tables.places:
        deck.ledger.translated("TABLE COLLECTION", place, "parameter_tables")


TABLES = {"PARAMETER TABLE TYPE": read_type, "TABLE COLLECTION": begin_collection, "PARAMETER TABLE": read_table}
