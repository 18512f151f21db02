"""Measures what a reader sees of every text of a page: what is cut off, what lies over another, what is covered."""

from __future__ import annotations

from playwright.sync_api import Page

_MEASURE = """() => {
    const free = document.createElement('style');
    free.textContent = '* { pointer-events: auto !important }';
    document.head.append(free);
    const meet = (p, q) => ({
        left: Math.max(p.left, q.left), right: Math.min(p.right, q.right),
        top: Math.max(p.top, q.top), bottom: Math.min(p.bottom, q.bottom),
    });
    const isSeen = (box) => box.right - box.left > 2 && box.bottom - box.top > 3;
    const isTiny = (box) => box.right - box.left <= 2 || box.bottom - box.top <= 2;
    const view = { left: 0, right: innerWidth, top: 0, bottom: innerHeight };
    const leaves = (box, frame) => ({
        x: frame.left - box.left > 1.5 || box.right - frame.right > 1.5,
        y: frame.top - box.top > 1.5 || box.bottom - frame.bottom > 1.5,
    });
    const styles = new Map();
    const style = (one) => styles.get(one) ?? styles.set(one, getComputedStyle(one)).get(one);
    const short = (text) => JSON.stringify(text.replace(/\\s+/g, ' ').trim().slice(0, 40));
    const name = (one) => one.closest('[data-testid]')?.dataset.testid ?? one.className;
    const found = new Set();
    const texts = [];
    // Opened over the page for a moment, and gone with Escape; lines that are dragged are wider than they look.
    const passing = 'dialog, [role=dialog], [role=menu], [role=separator], .in-place, .find, .outline-panel';
    // What is seen of a line of text; null where all of it is out of sight, as what is only read aloud.
    const seenOf = (text, parent, line) => {
        // A line is taller than its letters.
        const spare = Math.min(line.bottom - line.top - 4, 6) / 2;
        let box = { left: line.left, right: line.right, top: line.top + spare, bottom: line.bottom - spare };
        let scrolls = false, told = false;
        for (let one = parent; one !== null && one !== document.documentElement; one = one.parentElement) {
            const { overflowX, overflowY, display, position, textOverflow, webkitLineClamp, clipPath } = style(one);
            const frame = one.getBoundingClientRect();
            if (textOverflow === 'ellipsis' || webkitLineClamp !== 'none') told = true;
            if (clipPath !== 'none' && isTiny(frame)) return null;
            const clips = [overflowX !== 'visible', overflowY !== 'visible'];
            if (display !== 'inline' && (clips[0] || clips[1])) {
                if (isTiny(frame)) return null;
                const moves = one.closest('.canvas-pane') !== null;
                const x = moves || /auto|scroll/.test(overflowX), y = moves || /auto|scroll/.test(overflowY);
                const lost = leaves(box, frame);
                if (!told && !scrolls && ((clips[0] && !x && lost.x) || (clips[1] && !y && lost.y)))
                    found.add(`${short(text)} in ${name(parent)} is cut off`);
                scrolls ||= x || y;
                const both = meet(box, frame);
                if (clips[0]) [box.left, box.right] = [both.left, both.right];
                if (clips[1]) [box.top, box.bottom] = [both.top, both.bottom];
                if (!isSeen(box)) return null;
            }
            if (position === 'fixed') break;
        }
        const lost = leaves(box, view);
        if (!scrolls && (lost.x || lost.y)) found.add(`${short(text)} in ${name(parent)} is out of the window`);
        return { scrolls, ...meet(box, view) };
    };
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const visible = { opacityProperty: true, visibilityProperty: true };
    for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
        const parent = node.parentElement;
        if (node.data.trim() === '' || !parent.checkVisibility(visible)) continue;
        if (parent.closest('script, style, option, title, metadata, [hidden]') !== null) continue;
        const range = document.createRange();
        range.selectNodeContents(node);
        for (const line of range.getClientRects()) {
            const box = isSeen(line) ? seenOf(node.data, parent, line) : null;
            if (box !== null && isSeen(box)) texts.push({ node, parent, box });
        }
    }
    const isOpaque = (one) => {
        const { backgroundColor, backgroundImage } = style(one);
        const colour = backgroundColor.match(/[\\d.]+/g) ?? [];
        return colour.length === 3 || Number(colour[3] ?? 0) > 0.85 || backgroundImage !== 'none';
    };
    const shows = (parent, x, y) => {
        for (const one of document.elementsFromPoint(x, y)) {
            if (parent.contains(one) || one.contains(parent)) return true;
            if (isOpaque(one) || one.tagName === 'CANVAS') return false;
        }
        return false;
    };
    for (const { node, parent, box } of texts) {
        // What scrolls comes out from under it, as the graph does.
        if (box.scrolls || parent.closest(`${passing}, [inert]`) !== null) continue;
        const y = (box.top + box.bottom) / 2;
        for (const x of [box.left + 2, (box.left + box.right) / 2, box.right - 2]) {
            const over = document.elementsFromPoint(x, y).find((one) =>
                parent.contains(one) || one.contains(parent) || isOpaque(one) || one.tagName === 'CANVAS');
            if (over === undefined || parent.contains(over) || over.contains(parent) || over.closest(passing) !== null)
                continue;
            found.add(`${short(node.data)} in ${name(parent)} is covered by ${name(over)}`);
            break;
        }
    }
    texts.sort((p, q) => p.box.left - q.box.left);
    texts.forEach((p, at) => {
        for (const q of texts.slice(at + 1)) {
            if (q.box.left >= p.box.right) break;
            const both = meet(p.box, q.box);
            if (p.node === q.node || !isSeen(both)) continue;
            const [x, y] = [(both.left + both.right) / 2, (both.top + both.bottom) / 2];
            if (shows(p.parent, x, y) && shows(q.parent, x, y))
                found.add(`${short(p.node.data)} and ${short(q.node.data)} in ${name(q.parent)} lie over each other`);
        }
    });
    free.remove();
    return [...found];
}"""


def amiss(page: Page) -> list[str]:
    """What is amiss with the texts that are seen now, one sentence each."""
    found: list[str] = page.evaluate(_MEASURE)
    return found
