"""The texts of XML are taken out for translators and put in again, and what ships lacks none."""

from __future__ import annotations

import pytest

from kitrobot.translation.languages import TRANSLATED
from tools.xml_texts import lacking, put_in, xml_files

SOURCE = """<robot name="r">
  <label>Wheel &amp; <!-- no part of it -->co</label>
  <label xml:lang="fr">Roue</label>
  <sensor name="Eye"><label xml:lang="ur">آنکھ</label></sensor>
  <supply>glue</supply>
  <supply>a box</supply>
  <step><help>Go.</help></step>
  <phrase>{object} = {value}</phrase>
</robot>
"""


def english(source: str, language: str) -> list[str]:
    return [text.english for text in lacking(source.encode(), language)]


def test_a_text_that_lacks_a_translation_is_found_by_its_english_and_a_label_by_the_name_around_it() -> None:
    assert english(SOURCE, "pt") == ["Wheel & co", "Eye", "glue", "a box", "Go."]
    assert english(SOURCE, "fr") == ["Eye", "glue", "a box", "Go."]


def test_translations_stand_behind_the_english_text_in_the_order_of_their_codes_and_all_else_stays() -> None:
    table = {"Wheel & co": "Rueda <3", "Eye": "Ojo", "a box": "una caja", "Go.": "¡Ve!", "unused": "nada"}
    made = put_in(SOURCE.encode(), "es", table).decode()
    wanted = SOURCE.replace(
        '  <label xml:lang="fr">', '  <label xml:lang="es">Rueda &lt;3</label>\n  <label xml:lang="fr">'
    )
    wanted = wanted.replace('<label xml:lang="ur">', '<label xml:lang="es">Ojo</label><label xml:lang="ur">')
    wanted = wanted.replace("a box</supply>\n", 'a box</supply>\n  <supply xml:lang="es">una caja</supply>\n')
    assert made == wanted.replace("<help>Go.</help>", '<help>Go.</help><help xml:lang="es">¡Ve!</help>')
    assert put_in(made.encode(), "es", {**table, "Eye": "Otro"}).decode() == made
    assert english(made, "es") == ["glue"]


@pytest.mark.parametrize("language", TRANSLATED)
def test_nothing_that_ships_lacks_a_translation(language: str) -> None:
    files = xml_files()
    assert len(files) > 100
    assert [(path.name, one.english) for path in files for one in lacking(path.read_bytes(), language)] == []
