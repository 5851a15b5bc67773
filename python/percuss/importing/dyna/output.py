"""What a deck asks for as output."""


from ..ledger import Place


class Output:
    """Gathers the intervals and what is asked for."""

    def __init__(self) -> None:
        self.frames = self.rows = 0.0
        self.place = Place("", 0)  # of the last card
        self.history_place = Place("", 0)  # of the last that names nodes or elements
        self.asked: dict[str, Place] = {}  # *DATABASE_ files by their names
        self.nodes: list[int] = []
        self.elements: list[int] = []
        self.accelerometers: list[tuple[int, list[int], bool, Place]] = []  # id, nodes, whether gravity is removed
