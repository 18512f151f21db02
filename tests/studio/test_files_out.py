"""What a user keeps and prints: pictures that open again when they are dropped, image, listing, the printed sheet."""

from __future__ import annotations

import base64
import re
import zlib
from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import expect

from kitrobot.files.embedded_mission import carried_mission
from kitrobot.image.listing import assemble
from kitrobot.image.model import Image
from tests.effort import cases
from tests.studio.conftest import EXAMPLES, Studio
from tests.studio.looks import find_nothing

pytestmark = pytest.mark.browser

OpenStudio = Callable[[str | None], Studio]


def keep(studio: Studio, item: str, folder: Path) -> Path:
    """Chooses an entry of the menu File that hands out a file."""
    with studio.page.expect_download() as waiting:
        studio.at("menu-File").click()
        studio.at(f"menu-file-{item}").click()
    path = folder / waiting.value.suggested_filename
    waiting.value.save_as(path)
    return path


def drop_file(studio: Studio, path: Path) -> None:
    """Drops a file from the desktop onto the window."""
    data = studio.page.evaluate_handle(
        """([name, body]) => {
            const bytes = Uint8Array.from(atob(body), (letter) => letter.charCodeAt(0));
            const transfer = new DataTransfer();
            transfer.items.add(new File([bytes], name));
            return transfer;
        }""",
        [path.name, base64.b64encode(path.read_bytes()).decode()],
    )
    for event in ("dragenter", "dragover", "drop"):
        studio.at("canvas").dispatch_event(event, {"dataTransfer": data})


def choose_file(studio: Studio, path: Path) -> None:
    """Opens a file of this computer from the menu."""
    studio.page.keyboard.press("Control+o")
    studio.at("open-file").set_input_files(path)


def pages_of(pdf: bytes) -> int:
    return len(re.findall(rb"/Type\s*/Page\b", pdf))


def streams_of(pdf: bytes) -> list[bytes]:
    """The unpacked streams of a PDF, as far as they are packed by zlib."""
    found = []
    for match in re.finditer(rb"stream\r?\n", pdf):
        unpacker = zlib.decompressobj()
        try:
            found.append(unpacker.decompress(pdf[match.end() :]))
        except zlib.error:
            continue
    return found


def speak(studio: Studio, language: str) -> None:
    studio.at("menu-View").click()
    studio.at(f"menu-view-{language}").click()
    expect(studio.page.locator("html")).to_have_attribute("lang", language)


@pytest.mark.thorough(
    "test_pictures_open_again_and_files_and_paper_are_handed_out, of a smaller mission; what pictures carry: "
    "tests/files; read by the server: server/test_missions.py"
)
def test_a_picture_that_is_dropped_on_the_window_or_opened_from_the_menu_opens_its_mission(
    open_studio: OpenStudio, tmp_path: Path
) -> None:
    studio = open_studio("transport/transport.krt")
    before = studio.code()
    kept = {kind: keep(studio, f"export-{kind}", tmp_path) for kind in ("svg", "png")}
    mission = (EXAMPLES / "transport" / "transport.krt").read_bytes().strip()
    ways = [("svg", drop_file), ("png", choose_file)]
    for kind, opens in cases(ways, [("svg", choose_file), ("png", drop_file)]):
        path = kept[kind]
        assert path.name == f"carrier.{kind}"
        assert carried_mission(path.read_bytes(), path.name)[0].strip() == mission, kind
        studio.new_mission()
        opens(studio, path)
        expect(studio.at("tab-store-manager-A")).to_be_visible()
        studio.expect_code("Collision.IsPressed")
        assert studio.code() == before, kind
    again = keep(studio, "download-krt", tmp_path)
    assert again.read_bytes().strip() == mission


def the_image_and_the_listing_are_handed_out(studio: Studio, tmp_path: Path) -> None:
    image = keep(studio, "download-kri", tmp_path)
    listing = keep(studio, "download-kra", tmp_path)
    assert (image.name, listing.name) == ("carrier.kri", "carrier.kra")
    made = Image.from_bytes(image.read_bytes()).to_bytes()
    assert assemble(listing.read_text(encoding="utf-8"), "carrier.kra").to_bytes() == made


def a_program_with_errors_has_no_image_and_the_page_says_what_to_do(studio: Studio) -> None:
    studio.drop("While", "arc-start.next")
    expect(studio.page.locator('.vertex [class*="trouble"]').first).to_be_visible()
    for kind in ("kri", "kra"):
        studio.at("menu-File").click()
        studio.at(f"menu-file-download-{kind}").click()
        expect(studio.at("banner")).to_contain_text("“blink” has errors, so there is no image of it yet.")
        studio.page.get_by_role("button", name="Show the error").click()
        expect(studio.at("banner")).to_have_count(0)


def hold_the_print_window(studio: Studio) -> None:
    """It stays shut; the page's title says that it was asked for."""
    # In braces: Playwright calls what an expression gives when that is a function.
    studio.page.evaluate("() => { window.print = () => { document.title = `printing ${document.title}`; }; }")


def paper(studio: Studio, name: str) -> bytes:
    """What the browser prints, once it was asked to; `name` is what it would call a file."""
    expect(studio.page).to_have_title(f"printing {name}")
    pdf = studio.page.pdf(prefer_css_page_size=True, format="A4")
    studio.page.evaluate("window.dispatchEvent(new Event('afterprint'))")
    return pdf


def printed(studio: Studio, name: str) -> bytes:
    """What File, Print… prints."""
    hold_the_print_window(studio)
    studio.at("menu-File").click()
    studio.at("menu-file-print").click()
    return paper(studio, name)


def exported(studio: Studio, name: str, *choices: str) -> bytes:
    """What File, Export as PDF… prints, once that is chosen."""
    hold_the_print_window(studio)
    studio.at("menu-File").click()
    studio.at("menu-file-export-pdf").click()
    for choice in choices:
        studio.at(f"pdf-{choice}").check()
    studio.at("pdf-print").click()
    expect(studio.at("pdf-dialog")).to_have_count(0)
    return paper(studio, name)


def sheet(studio: Studio) -> None:
    """Shows the sheet as it is while the browser prints."""
    studio.page.evaluate("window.dispatchEvent(new Event('beforeprint'))")
    studio.page.emulate_media(media="print")


def leave_the_sheet(studio: Studio) -> None:
    studio.page.emulate_media(media="null")
    studio.page.evaluate("window.dispatchEvent(new Event('afterprint'))")
    expect(studio.at("print-sheet")).to_have_count(0)


def the_sheet_has_everything_and_nothing_of_the_studio(studio: Studio) -> None:
    pdf = printed(studio, "Transport as a team")
    # The title and the team, then each program with its graph and its text.
    assert 6 <= pages_of(pdf) <= 11, studio.page.evaluate("document.body.innerText")
    sheet(studio)
    place = studio.at("print-sheet")
    expect(place.get_by_role("heading", level=1)).to_have_text("Transport as a team")
    expect(place).to_contain_text("Three carriers")
    expect(place.locator("tbody tr")).to_have_count(7)
    names = ["carrier", "loader", "unloader", "store-manager-A", "store-manager-B"]
    expect(place.locator(".sheet-program > div > h2")).to_have_text(names)
    expect(place.locator("pre").first).to_contain_text("<Collision.IsPressed()>(")
    assert place.locator("figure svg text", has_text="Drive").count() >= 2
    for chrome in ("menu-File", "canvas", "run-button", "code"):
        expect(studio.at(chrome)).to_be_hidden()
    leave_the_sheet(studio)
    expect(studio.at("canvas")).to_be_visible()


def a_pdf_has_all_programs_or_the_one_in_view_and_its_graph_whole_on_a_page(studio: Studio) -> None:
    title = studio.page.title()
    name = "Transport as a team · carrier"
    assert pages_of(exported(studio, name, "one", "fit")) == 2
    # What was printed is gone, and the page has its name again.
    expect(studio.page).to_have_title(title)
    sheet(studio)
    place = studio.at("print-sheet")
    expect(place.locator(".sheet-program > div > h2")).to_have_text(["carrier"])
    expect(place.locator("figure")).to_have_count(1)
    expect(place.locator("table")).to_have_count(0)
    leave_the_sheet(studio)
    assert pages_of(exported(studio, "Transport as a team", "all", "pages")) > 5


def the_sheet_is_black_on_white_in_every_theme_and_in_the_pages_language(studio: Studio) -> None:
    studio.at("menu-View").click()
    studio.at("menu-view-dark").click()
    speak(studio, "ur")
    pdf = printed(studio, "ٹیم مل کر سامان لے جائے")
    assert b"/Subtype /Image" not in pdf
    # Who searches the file finds the word for Start: its letters are there, though drawn joined.
    letters = b"".join(stream for stream in streams_of(pdf) if b"beginbf" in stream).upper()
    for letter in "آغاز":
        assert b"<%04X>" % ord(letter) in letters
    sheet(studio)
    place = studio.at("print-sheet")
    colours = place.evaluate("one => [getComputedStyle(one).color, getComputedStyle(one).backgroundColor]")
    assert colours == ["rgb(0, 0, 0)", "rgb(255, 255, 255)"]
    assert place.locator("figure svg > rect").first.get_attribute("fill") in ("#fff", "#ffffff")
    expect(place.get_by_role("heading", level=1)).to_have_text("ٹیم مل کر سامان لے جائے")
    right = place.locator("h1").evaluate("one => getComputedStyle(one).direction")
    assert (right, place.locator("pre").first.evaluate("one => getComputedStyle(one).direction")) == ("rtl", "ltr")


@pytest.mark.thorough(
    "test_pictures_open_again_and_files_and_paper_are_handed_out, of a smaller mission; "
    "web/src/features/export/sheet: cuts.test.ts; images: server/test_images.py"
)
def test_all_graphs_image_listing_and_the_sheet_of_a_mission_in_every_theme_and_the_pages_language(
    open_studio: OpenStudio, tmp_path: Path
) -> None:
    studio = open_studio("transport/transport.krt")
    the_image_and_the_listing_are_handed_out(studio, tmp_path)
    the_sheet_has_everything_and_nothing_of_the_studio(studio)
    a_pdf_has_all_programs_or_the_one_in_view_and_its_graph_whole_on_a_page(studio)
    the_sheet_is_black_on_white_in_every_theme_and_in_the_pages_language(studio)


def ctrl_p_prints_the_sheet_too(studio: Studio) -> None:
    hold_the_print_window(studio)
    studio.page.keyboard.press("Control+p")
    pdf = paper(studio, "Blink while driving")
    assert pages_of(pdf) >= 1
    assert b"/Subtype /Image" not in pdf


def the_svg_shows_every_vertex_in_words(studio: Studio, tmp_path: Path) -> None:
    text = keep(studio, "export-svg", tmp_path).read_text(encoding="utf-8")
    assert text.count(">On</text>") == 1
    assert text.count(">Wait</text>") == 3
    assert ">Run is true</text>" in text
    assert ">At the same time</text>" in text
    assert "var(" not in text


def a_picture_without_a_mission_is_told_and_changes_nothing(studio: Studio, tmp_path: Path) -> None:
    studio.expect_code("Light.LightOn")
    before = studio.code()
    path = tmp_path / "cat.svg"
    path.write_text('<svg xmlns="http://www.w3.org/2000/svg"/>', encoding="utf-8")
    choose_file(studio, path)
    expect(studio.page.get_by_text("is a picture without a mission inside")).to_be_visible()
    assert studio.code() == before
    studio.faults[:] = [fault for fault in studio.faults if "400" not in fault and "422" not in fault]


def the_sheet_is_black_on_white_and_searched_in_its_own_language(studio: Studio) -> None:
    speak(studio, "ur")
    hold_the_print_window(studio)
    studio.page.keyboard.press("Control+p")
    name = studio.page.title().removeprefix("printing ")
    pdf = paper(studio, name)
    assert b"/Subtype /Image" not in pdf
    assert pages_of(pdf) >= 1
    letters = b"".join(stream for stream in streams_of(pdf) if b"beginbf" in stream).upper()
    for letter in "آغاز":
        assert b"<%04X>" % ord(letter) in letters
    sheet(studio)
    place = studio.at("print-sheet")
    colours = place.evaluate("one => [getComputedStyle(one).color, getComputedStyle(one).backgroundColor]")
    assert colours == ["rgb(0, 0, 0)", "rgb(255, 255, 255)"]
    right = place.locator("h1").evaluate("one => getComputedStyle(one).direction")
    assert (right, place.locator("pre").first.evaluate("one => getComputedStyle(one).direction")) == ("rtl", "ltr")
    find_nothing(studio, "the printed sheet", within="[data-testid='print-sheet']")
    for chrome in ("menu-File", "canvas", "run-button", "code"):
        expect(studio.at(chrome)).to_be_hidden()
    leave_the_sheet(studio)


def test_pictures_open_again_and_files_and_paper_are_handed_out(open_studio: OpenStudio, tmp_path: Path) -> None:
    studio = open_studio("blink/blink.krt")
    studio.expect_code("Light.LightOn")
    before = studio.code()
    mission = (EXAMPLES / "blink" / "blink.krt").read_bytes().strip()
    kept = {kind: keep(studio, f"export-{kind}", tmp_path) for kind in ("svg", "png")}
    image, listing = (keep(studio, f"download-{kind}", tmp_path) for kind in ("kri", "kra"))
    made = Image.from_bytes(image.read_bytes()).to_bytes()
    assert assemble(listing.read_text(encoding="utf-8"), "blink.kra").to_bytes() == made
    for kind, opens in (("svg", drop_file), ("png", choose_file)):
        assert carried_mission(kept[kind].read_bytes(), kept[kind].name)[0].strip() == mission, kind
        studio.new_mission()
        opens(studio, kept[kind])
        studio.expect_code("Light.LightOn")
        assert studio.code() == before, kind
    a_picture_without_a_mission_is_told_and_changes_nothing(studio, tmp_path)
    the_sheet_is_black_on_white_and_searched_in_its_own_language(studio)


@pytest.mark.thorough(
    "test_pictures_open_again_and_files_and_paper_are_handed_out; words of pictures: web/src/components/graph in "
    "test_clipping.py; a program with errors: server/test_images.py"
)
def test_pictures_have_words_and_a_mission_errors_have_no_image_and_ctrl_p_prints(
    open_studio: OpenStudio, tmp_path: Path
) -> None:
    studio = open_studio("blink/blink.krt")
    the_svg_shows_every_vertex_in_words(studio, tmp_path)
    a_picture_without_a_mission_is_told_and_changes_nothing(studio, tmp_path)
    a_program_with_errors_has_no_image_and_the_page_says_what_to_do(studio)
    studio.take_back()
    ctrl_p_prints_the_sheet_too(studio)


@pytest.mark.thorough("web/src/features/export/sheet/cuts.test.ts")
def test_a_long_graph_is_cut_into_parts_between_its_vertices(open_studio: OpenStudio) -> None:
    studio = open_studio("blink/blink.krt")
    studio.edit_code()
    studio.page.keyboard.press("Control+a")
    studio.page.keyboard.insert_text("WAIT(1);\n" * 60)
    canvas = studio.at("canvas")
    expect(canvas.get_by_text("LightOn")).to_have_count(0)
    expect(canvas.get_by_text("Wait").nth(5)).to_be_visible()
    pdf = printed(studio, "Blink while driving")
    sheet(studio)
    parts = studio.at("print-sheet").locator("figure")
    assert parts.count() >= 4
    expect(parts.nth(1)).to_contain_text("part 2 of")
    assert pages_of(pdf) >= parts.count()
    # Each part fits on the paper, and every vertex is whole on one of them.
    heights = parts.evaluate_all("all => all.map((one) => one.getBoundingClientRect().height)")
    assert max(heights) <= 267 / 25.4 * 96
    whole = parts.locator("svg").evaluate_all(
        """all => all.flatMap((svg) => {
            const box = svg.viewBox.baseVal;
            return [...svg.querySelectorAll('text')].filter((text) => text.textContent === 'Wait').filter((text) => {
                const y = Number(text.getAttribute('y'));
                return y - 22 >= box.y && y + 22 <= box.y + box.height;
            }).map((text) => text.getAttribute('y'));
        })"""
    )
    assert len(set(whole)) == 60
