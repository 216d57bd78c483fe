// Comforts: the page says all that it says without them.
"use strict";
document.documentElement.classList.add("scripted");
const all = (selector, within = document) => [...within.querySelectorAll(selector)];

// Only what is not passed; all checks open or closed.
for (const button of all("[data-toggle]"))
    button.addEventListener("click", () => {
        const on = button.getAttribute("aria-pressed") !== "true";
        button.setAttribute("aria-pressed", on);
        if (button.dataset.toggle === "open") for (const check of all("details.check")) check.open = on;
        else document.body.classList.toggle("only_open", on);
    });

// The order of the rows: as in the handout, or by the points that are still to be had.
for (const button of all("[data-sort]")) {
    const body = document.querySelector(".overview tbody"), rows = [...body.rows];
    button.addEventListener("click", () => {
        const on = button.getAttribute("aria-pressed") !== "true";
        button.setAttribute("aria-pressed", on);
        const lost = row => Number(row.dataset.lost);
        const sorted = on ? rows.filter(row => row.dataset.lost).sort((a, b) => lost(b) - lost(a)) : rows;
        body.replaceChildren(...sorted);
    });
}

// n and p: the next and the previous fragment that does not pass.
document.addEventListener("keydown", event => {
    if (event.ctrlKey || event.altKey || event.metaKey || /^(INPUT|TEXTAREA)$/.test(event.target.tagName)) return;
    const step = { n: 1, p: -1 }[event.key];
    if (!step) return;
    const open = all("section.card[id]:not(.is_passed):not(#overview)"), middle = window.innerHeight / 3;
    const places = open.map(section => section.getBoundingClientRect().top - middle);
    const next = step > 0 ? places.findIndex(place => place > 1) : places.findLastIndex(place => place < -1);
    if (next < 0) return;
    window.scrollBy({ top: places[next] });
    const name = open[next].querySelector("h3");
    name.tabIndex = -1;
    name.focus({ preventScroll: true });
});

// In print all is unfolded, also where the browser does not know the rule in page.css.
let folded = [];
window.addEventListener("beforeprint", () => {
    folded = all("details:not([open])");
    for (const details of folded) details.open = true;
});
window.addEventListener("afterprint", () => { for (const details of folded) details.open = false; });

// Yours over the right one: a border that is drawn across, or both in turn; and the radiance below the pointer, read off
// the previews. Those have 8 bits: two digits, and what is white there may be brighter.
const compare = pictures => {
    const [mine, right] = all("img", pictures);
    if (!right) return;
    const box = document.createElement("div"), stack = document.createElement("div");
    const canvas = document.createElement("canvas"), values = document.createElement("output");
    const line = document.createElement("i"), labels = ["yours", "the right one"].map(text =>
        Object.assign(document.createElement("b"), { textContent: text }));
    const exposure = Number(pictures.dataset.exposure);
    const slider = Object.assign(document.createElement("input"),
        { type: "range", min: 0, max: 100, value: 50, ariaLabel: "how much of yours is shown over the right one, from the left [%]" });
    const flicker = Object.assign(document.createElement("button"), { type: "button", textContent: "flicker" });
    flicker.setAttribute("aria-pressed", false);
    let turn = null, shows = 0, at = null;
    const linear = byte => { const x = byte / 255; return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4; };
    const radiance = byte => (byte === 255 ? "≥" : "") + Number((linear(byte) / exposure).toPrecision(2));
    const texts = [mine, right].map(picture => {
        const read = Object.assign(document.createElement("canvas"), { width: mine.naturalWidth, height: mine.naturalHeight });
        const context = read.getContext("2d", { willReadFrequently: true });
        context.drawImage(picture, 0, 0);
        return (x, y) => [...context.getImageData(x, y, 1, 1).data].slice(0, 3).map(radiance).join(" ");
    });
    canvas.width = mine.naturalWidth, canvas.height = mine.naturalHeight;
    const draw = () => {
        const context = canvas.getContext("2d"), border = canvas.width * slider.value / 100;
        context.drawImage(turn ? [mine, right][shows] : right, 0, 0);
        if (!turn && border > 0) context.drawImage(mine, 0, 0, border, canvas.height, 0, 0, border, canvas.height);
        line.className = "border", line.hidden = Boolean(turn);
        line.style.left = `${slider.value}%`, line.style.height = `${canvas.clientHeight}px`;
        labels[0].hidden = turn ? shows !== 0 : slider.value < 12, labels[1].hidden = turn ? shows !== 1 : slider.value > 80;
        values.textContent = at ? `radiance of pixel ${at}: yours ${texts[0](...at)}, the right one ${texts[1](...at)}`
            : turn ? ["yours", "the right one"][shows] : "left of the line yours, right of it the right one";
    };
    slider.addEventListener("input", draw);
    flicker.addEventListener("click", () => {
        turn = turn ? clearInterval(turn) : setInterval(() => { shows = 1 - shows; draw(); }, 600);
        flicker.setAttribute("aria-pressed", Boolean(turn));
        draw();
    });
    canvas.addEventListener("pointermove", event => {
        const place = canvas.getBoundingClientRect();
        at = [Math.floor((event.clientX - place.left) / place.width * canvas.width),
              Math.floor((event.clientY - place.top) / place.height * canvas.height)];
        draw();
    });
    canvas.addEventListener("pointerleave", () => { at = null; draw(); });
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "yours over the right one");
    box.className = "compare", stack.className = "stack";
    stack.append(canvas, line, ...labels, values);
    box.append(slider, stack, flicker);
    pictures.after(box);
    draw();
    new ResizeObserver(draw).observe(stack);
    slider.focus({ preventScroll: true });  // the button that had the focus is gone
    box.scrollIntoView({ block: "nearest" });
};
for (const pictures of all(".pictures")) {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: "compare" });
    if (all("img", pictures).length < 2) continue;
    button.addEventListener("click", async () => {
        await Promise.all(all("img", pictures).map(picture => { picture.loading = "eager"; return picture.decode(); }));
        button.remove();
        compare(pictures);
    });
    const figure = document.createElement("div");
    figure.className = "compare";
    figure.append(button);
    pictures.after(figure);
}
