"""The interactive view as a piece of a page."""

import json

from percuss.report.markup import escape

from .surface import read_library, read_viewer

MISSING = "three.js is missing (scripts/install_dependencies --report installs libjs-three)"


def embed_view(about, data, sentence, note):
    """The view of a surface that is packed. note: takes a text for the user where there can be none."""
    library = read_library()
    if library is None:
        note(f"no interactive view: {MISSING}")
        return "<p class=soft>The interactive view needs three.js (Debian's package libjs-three) where the report is written.</p>"
    code = "".join(f"<script>{text.replace('</script', '<' + chr(92) + '/script')}</script>" for text in (*library, read_viewer()))
    return (_VIEW + f"<p class=soft>{escape(sentence)}</p>"
            f"<script type='application/json' id=surface-about>{json.dumps(about).replace('<', chr(92) + 'u003c')}</script>"
            f"<script type='text/plain' id=surface-data>{data}</script>{code}")


def describe_view(about, frames, reduced_by):
    """The sentence below a view. frames: how many the run has; reduced_by: what has been reduced."""
    counted = f"{about['frames']} of {frames} frames, {about['faces']:,} faces."
    return f"{counted} Reduced to fit into a page: {'; '.join(reduced_by)}." if reduced_by else counted


_VIEW = """<div id=view><div class=stage><canvas tabindex=0 aria-label='The surface of the run'></canvas></div>
<div class='row time'><button class=play>Play</button><input type=range min=0 step=1 aria-label=Frame><span class=clock></span></div>
<div class=row><div class=bar><div class=bar-title></div><i></i><div class=bar-labels></div></div>
<button data-view='-50:22'>Default view</button><button data-view='0:0.01'>Along x</button>
<button data-view='-90:0.01'>Along y</button><button data-view='-90:89.9'>Along z</button>
<label><input type=checkbox class=edges>Edges</label><label><input type=checkbox class=by-part>Colours by part</label></div>
<div class='row tools' style='display:none'><label>Field <select class=fields></select></label>
<label>Bar <input type=number step=any class=bar-low aria-label='Low end of the bar'> to
<input type=number step=any class=bar-high aria-label='High end of the bar'></label>
<label><input type=checkbox class=bar-frame>Of this frame</label>
<label>Deformation <input type=range class=swell min=0 max=20 step=0.5 value=1> x <span class=factor>1</span></label>
<label><input type=checkbox class=walls checked>Rigid walls</label>
<label><input type=checkbox class=outline>Start as outline</label><label><input type=checkbox class=mark checked>Largest value</label>
<label>Mirror <select class=mirror></select></label>
<label>Arrows <select class=arrows><option value=''>none</option></select></label>
<input type=range class=arrow-size min=0.2 max=5 step=0.1 value=1 aria-label='Length of arrows'><span class='arrow-note soft'></span>
<label>Cut <select class=cut><option value=''>none</option><option value=x>across x</option><option value=y>across y</option>
<option value=z>across z</option><option value=view>across the view</option></select></label>
<input type=range class='cut-place of-cut' min=0 max=1 step=0.002 aria-label='Place of the cut'><button class='flip of-cut'>Other side</button>
<span class='cut-note of-cut soft'></span><b class=value></b><div class=keys hidden></div></div>
<div class='row parts'></div><div class='row layers'></div><div class='row note soft'>Loading ...</div></div>"""
