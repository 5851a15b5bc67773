"""Vector graphics of the pages in a small form."""
import pathlib


def shrink(path):
    """Rewrites a picture that matplotlib made with short numbers and names, on one line; not without scour."""
    try:
        from scour import scour
    except ImportError:
        return
    options = scour.parse_args(["--set-precision=5", "--enable-comment-stripping", "--shorten-ids", "--indent=none",
                                "--disable-style-to-xml",  # font is no attribute of SVG
                                "--no-line-breaks", "--strip-xml-prolog"])
    path = pathlib.Path(path)
    path.write_text(scour.scourString(path.read_text(encoding="utf-8"), options), encoding="utf-8")
