"""Starting a class: where it listens, who can reach that, the code and its picture in the terminal, and a clean end."""

from __future__ import annotations

import ipaddress
import socket
import sys
import threading
import webbrowser
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

from kitrobot.classroom.class_room import SITE, ClassRoom
from kitrobot.classroom.record import unread_sentence
from kitrobot.classroom.teacher_actions import TeacherActions
from kitrobot.server.classroom.certificate import usable_certificate
from kitrobot.server.classroom.own_certificate import OwnCertificate, own_certificate
from kitrobot.server.classroom.qr_codes import qr_rows, qr_text
from kitrobot.server.fallback_pages import secure_address
from kitrobot.server.hosts import host_number, is_loopback, machine_addresses, machine_names
from kitrobot.server.presence import Presence
from kitrobot.server.studio_server import ServerError, has_screen, listen, print_address
from kitrobot.server.tls_door import PlainReply, certificate_address
from kitrobot.text.collection import collection_paused
from kitrobot.text.sentences import Sentence
from kitrobot.translation.reader_language import best_language, override_language, translate

if TYPE_CHECKING:
    from kitrobot.classroom.overview import JoinAddress


@dataclass(frozen=True)
class ClassSettings:
    """How a class is to be opened: `tls` is a certificate and its key, `https` asks for one of the class's own;
    `new_code` instead of the one it had; `site` the folder of a static site, None for that in the folder of the class,
    if there is one.
    """

    folder: Path
    host: str = "127.0.0.1"
    port: int | None = None
    tls: tuple[Path, Path] | None = None
    https: bool = False
    browser: bool = True
    new_code: bool = False
    site: Path | None = None


def serve_class(opening: ClassSettings) -> None:
    """Serves a class until Ctrl-C.

    Raises:
        ServerError: it cannot listen there, or the certificate cannot be used or made.
        ClassError: the class of the folder runs already.
        FileError: the folder, the certificate or its key cannot be used.
        SiteError: the site cannot be used.
    """
    address = _address(opening.host)
    if opening.tls is not None:
        usable_certificate(*opening.tls)
    site = _site(opening)
    shown = _shown(address)
    own = own_certificate(shown, _other_names(address)) if opening.https else None
    room = ClassRoom(opening.folder)
    try:
        if opening.new_code or not room.record.code:
            TeacherActions(room).set_code(True)
        _serve(room, (address, shown), opening, site, own)
    finally:
        room.close()


def _site(opening: ClassSettings) -> Path | None:
    """The site that pupils' pages have their Python from.

    Raises:
        SiteError: it cannot be used.
    """
    from kitrobot.packaging.site import expect_site

    site = opening.site
    if site is None and (opening.folder / SITE).is_dir():
        site = opening.folder / SITE
    if site is not None:
        expect_site(site)
    return site


def _serve(
    room: ClassRoom, addresses: tuple[str, str], opening: ClassSettings, site: Path | None, own: OwnCertificate | None
) -> None:
    """Serves until Ctrl-C. `addresses`: the one that is listened on, and the one that pupils open."""
    address, shown = addresses
    tls = opening.tls if own is None else (own.path, own.path)
    first = listen(address, opening.port)
    number = first.getsockname()[1]
    listening = [first]
    if not is_loopback(address) and not _is_any(address):
        # The teacher's page is for this machine; it is at the number that all machines have for themselves.
        listening.append(listen("127.0.0.1", number))
    # Only now: where it cannot listen, nobody waits for the web server to load.
    from kitrobot.classroom.overview import JoinAddress

    with collection_paused():
        from kitrobot.server.classroom.app import create_class_app
        from kitrobot.server.classroom.gateway import new_key
        from kitrobot.server.web_server import Tls, run_server

    scheme = "http" if tls is None else "https"
    pupils = f"{scheme}://{_name(shown)}:{number}/"
    home = f"{scheme}://{'127.0.0.1' if tls is None else _name(shown)}:{number}/"
    key = new_key()
    reach = JoinAddress(pupils, qr_rows(pupils), reach_sentence(address, tls is not None))
    made = create_class_app(room, key, reach, site=site)
    teacher = f"{home}teacher?token={key}"

    def ready() -> None:
        print_address(teacher)
        for line in _welcome(room, reach, site, own):
            print(line, file=sys.stderr, flush=True)
        if opening.browser and has_screen():
            threading.Thread(target=_open_browser, args=(room.folder, teacher), daemon=True).start()

    try:
        run_server(made.app, listening, ready, tls and Tls(*tls, _greeting(pupils, own)))
    finally:
        made.close()
        for one in listening:
            one.close()


def _greeting(address: str, own: OwnCertificate | None) -> PlainReply:
    """What is said to who opens the address without `https`."""
    host = urlsplit(address).netloc.rpartition(":")[0]
    paragraphs = [] if own is None else [warning_sentence(host), trust_sentence("{certificate}")]

    def page(languages: str) -> str:
        with override_language(best_language(languages)):
            return secure_address(address, *paragraphs)

    return PlainReply(page, b"" if own is None else own.public.read_bytes())


def warning_sentence(host: str) -> Sentence:
    """What to do where a browser warns of the class's own certificate."""
    return Sentence(
        "At the first visit the browser warns, because it does not know the certificate of this class. In Chrome and"
        " Edge press `Advanced`, then `Proceed to {host}`; in Firefox `Advanced`, then `Proceed` or `Accept the Risk"
        " and Continue`; in Safari `Show Details`, then `visit this website`.",
        host,
    )


def trust_sentence(address: str) -> Sentence:
    """How a machine comes to trust the class's own certificate, which is at that address."""
    return Sentence(
        "No browser warns on a machine that trusts the class: where your teacher asks you to, install its certificate"
        " from {address}",
        address,
    )


def _certificate_lines(own: OwnCertificate, address: str) -> list[str]:
    host = urlsplit(address).hostname or ""
    made = Sentence("The certificate is new; its fingerprint (SHA-256) is")
    kept = Sentence("The certificate is the same as before; its fingerprint (SHA-256) is")
    return [
        translate(warning_sentence(host)),
        translate(made if own.new else kept),
        own.fingerprint,
        translate(trust_sentence(certificate_address(address))),
        translate(Sentence("and compare the fingerprint that it shows with this one:")),
        own.authority_fingerprint,
        translate(
            Sentence(
                "Pupils' pages then reach boards that are plugged in. They open without the network in Firefox, and in"
                " Chrome and Edge where {file} is installed as trusted. Both need a site.",
                own.public,
            )
        ),
        "",
    ]


def _welcome(room: ClassRoom, reach: JoinAddress, site: Path | None, own: OwnCertificate | None) -> list[str]:
    code = room.record.code
    runs = Sentence("Programs of pupils run in their own browsers.")
    if site is None:
        runs = Sentence(
            "Programs of pupils run on this machine. For more than a few pupils write a site into {folder}"
            " (`kitrobot site`): then they run in the pupils' own browsers.",
            room.folder / SITE,
        )
    return [
        translate(Sentence("The page for the teacher is at the address above; keep it to yourself.")),
        "",
        qr_text(reach.address) if sys.stderr.isatty() else "",
        translate(Sentence("Pupils open {address}", reach.address)),
        translate(Sentence("and type the code {code}", f"{code[:3]} {code[3:]}")),
        "",
        *([] if own is None else _certificate_lines(own, reach.address)),
        translate(reach.sentence),
        translate(runs),
        translate(Sentence("The work of the class is in the folder {folder}. Ctrl-C ends the class.", room.folder)),
        *(translate(unread_sentence(one)) for one in room.record.unread),
    ]


def reach_sentence(address: str, secure: bool) -> Sentence:
    """Who can reach the class."""
    if is_loopback(address):
        return Sentence(
            "Only this machine can reach the class; for pupils at others start it with `--host {address}`.",
            _own_address(),
        )
    if secure:
        return Sentence("Everybody in the network of this machine can reach the class; who has the code comes in.")
    return Sentence(
        "Everybody in the network of this machine can reach the class; who has the code comes in. What is sent can be"
        " read in that network: `--https` prevents it."
    )


def _address(host: str) -> str:
    """The address to bind to.

    Raises:
        ServerError: it is no number.
    """
    try:
        return str(ipaddress.ip_address(host_number(host)))
    except ValueError:
        raise ServerError(
            Sentence("`{host}` is no address of this machine", host),
            Sentence("give its number in the network: perhaps {address}", _own_address()),
        ) from None


def _is_any(address: str) -> bool:
    return ipaddress.ip_address(address).is_unspecified


def _shown(address: str) -> str:
    """The address that pupils open, of one that is listened on."""
    return _own_address() if _is_any(address) else address


def _other_names(address: str) -> list[str]:
    """How else pupils reach a class that listens on that address: names of this machine, and all its addresses."""
    if is_loopback(address):
        return []
    return [*machine_names(), *(machine_addresses() if _is_any(address) else ())]


def _own_address() -> str:
    """This machine's address in the network, as far as it is known; nothing is sent for it."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as asked:
        try:
            asked.connect(("192.0.2.1", 9))
            return str(asked.getsockname()[0])
        except OSError:
            return "127.0.0.1"


def _name(host: str) -> str:
    return f"[{host}]" if ":" in host else host


def _open_browser(folder: Path, address: str) -> None:
    """Opens the browser, without the key in its command line: other users of this machine can read that."""
    page = Presence(folder).write_redirect_page(address)
    if page is not None:
        webbrowser.open(page.as_uri())
