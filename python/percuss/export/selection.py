"""The frames and fields that are written."""

from percuss.results.arrays import Array
from percuss.results.fields import Fields

from ..errors import NotResults
from ..nearest import suggest

TENSOR = ("xx", "yy", "zz", "xy", "yz", "zx")  # the order of six components in fields.vtkhdf
VECTOR = ("x", "y", "z")


class Selection:
    """Attributes: fields (a Fields), frames (numbers), names {field:
    'node' or 'element'}, of those that were chosen."""

    def __init__(self, fields: Fields, frames: str = "all", names: list[str] | None = None) -> None:
        self.fields = fields
        self.frames = parse_frames(frames, len(fields.times))
        known = {name: place for name, place in fields.names().items() if name != "part"}  # every file has the part
        for name in names or ():
            if name not in known:
                raise NotResults(f"there is no field '{name}' in {fields.path}{suggest(name, known)} "
                                 f"(it has {', '.join(sorted(known))})")
        self.names = {name: known[name] for name in (names or known)}

    @property
    def title(self) -> str:
        return self.fields.title or "percuss"

    def data(self, name: str, frame: int) -> Array:
        return self.fields.data(name, frame)


def parse_frames(text: str, count: int) -> list[int]:
    """Numbers of 'all', '0,5,-1' and '0..20:5' (from, to, each fifth), ascending."""
    if text == "all":
        return list(range(count))
    found: set[int] = set()
    for word in text.split(","):
        try:
            first, dots, rest = word.partition("..")
            last, _, step = rest.partition(":") if dots else (first, "", "")
            low, high = (_find_frame(int(w), count) for w in (first, last))
            found.update(range(low, high + 1, int(step or 1)))
        except ValueError:
            raise NotResults(f"'{text}' names no frames (all, 0,5,-1 or 0..20:5; "
                             f"there are {count}, from 0 to {count - 1})") from None
    if not found:
        raise NotResults(f"'{text}' names no frame")
    return sorted(found)


def _find_frame(number: int, count: int) -> int:
    if not -count <= number < count:
        raise ValueError
    return number % count


def name_components(name: str, width: int) -> list[str]:
    """['velocity_x', ...]; the name itself of a number."""
    endings = {1: ("",), 3: VECTOR, 6: TENSOR}.get(width) or range(width)
    return [f"{name}_{ending}" if ending != "" else name for ending in endings]
