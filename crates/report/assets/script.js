"use strict";
(() => {
  const all = (selector, root = document) => [...root.querySelectorAll(selector)];

  // Links lead to folded sections: unfold the one that is meant.
  const unfold = () => {
    const target = document.getElementById(location.hash.slice(1));
    if (target && target.matches("details")) { target.open = true; target.scrollIntoView(); }
  };
  addEventListener("hashchange", unfold);
  unfold();
  addEventListener("beforeprint", () => all("details").forEach((d) => { d.open = true; }));

  // Copy a command.
  all(".repro code").forEach((code) => {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "copy";
    button.textContent = "Copy";
    code.after(button);
    button.addEventListener("click", () => {
      const done = () => { button.textContent = "Copied"; setTimeout(() => { button.textContent = "Copy"; }, 1500); };
      const select = () => getSelection().selectAllChildren(code);
      if (navigator.clipboard) navigator.clipboard.writeText(code.textContent).then(done, select);
      else select();
    });
  });

  // Sort the table.
  const table = document.getElementById("all");
  const body = table.tBodies[0];
  const heads = all("thead th", table);
  const key = (row, i) => {
    const cell = row.cells[i];
    if (!("key" in cell.dataset)) return cell.textContent.trim().toLowerCase();
    return cell.dataset.key === "" ? Infinity : Number(cell.dataset.key);
  };
  const sort = (i) => {
    const up = heads[i].getAttribute("aria-sort") !== "ascending";
    heads.forEach((head) => head.removeAttribute("aria-sort"));
    heads[i].setAttribute("aria-sort", up ? "ascending" : "descending");
    const order = (a, b) => (a < b ? -1 : a > b ? 1 : 0);
    const rows = [...body.rows].sort((a, b) => order(key(a, i), key(b, i)) * (up ? 1 : -1));
    body.append(...rows);
  };
  heads.forEach((head, i) => {
    const button = document.createElement("button");
    button.type = "button";
    button.className = "sort";
    button.append(...head.childNodes);
    button.addEventListener("click", () => sort(i));
    head.append(button);
  });

  // Filter it.
  const filter = document.getElementById("filter");
  const chips = all(".chips button");
  const show = () => {
    const words = filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    const on = (verdict) => chips.some((c) => c.dataset.verdict === verdict && c.getAttribute("aria-pressed") === "true");
    let shown = 0;
    for (const row of body.rows) {
      const text = row.textContent.toLowerCase();
      const fits = words.every((w) => text.includes(w)) && on(row.dataset.class) && (!on("odd") || "odd" in row.dataset);
      row.hidden = !fits;
      if (fits) shown += 1;
    }
    document.getElementById("shown").textContent = `${shown} of ${body.rows.length}`;
  };
  filter.closest(".filter").hidden = false;
  filter.addEventListener("input", show);
  chips.forEach((chip) => chip.addEventListener("click", () => {
    chip.setAttribute("aria-pressed", chip.getAttribute("aria-pressed") === "true" ? "false" : "true");
    show();
  }));
  show();

  // Values under the pointer, or under the arrow keys.
  const SPACE = "http://www.w3.org/2000/svg";
  const axis = ([label, log, lo, hi, from, to]) => ({ label, log, lo, hi, from, to });
  const panels = (plot) => plot.panels.map(([x, y]) => ({ x: axis(x), y: axis(y) }));
  const value = (axis, at) => {
    const share = (at - axis.from) / (axis.to - axis.from);
    return axis.log ? axis.lo * (axis.hi / axis.lo) ** share : axis.lo + share * (axis.hi - axis.lo);
  };
  const digits = (x) => Number(x.toPrecision(4)).toString();
  // The lines of a path, of the few commands that the report writes: m dx dy, l dx dy, h dx, v dy.
  const lines = (path) => {
    const found = [];
    let x = 0, y = 0, command = "", line = [], size = 2, numbers = [];
    for (const token of path.getAttribute("d").match(/[mlhv]|-?\d+/g)) {
      if (/[mlhv]/.test(token)) { command = token; size = "hv".includes(token) ? 1 : 2; numbers = []; continue; }
      numbers.push(Number(token));
      if (numbers.length < size) continue;
      const [a, b] = numbers;
      numbers = [];
      if (command === "m") { line = []; found.push(line); }
      if (command !== "v") x += a;
      if (command !== "h") y += command === "v" ? a : b;
      line.push([x, y]);
    }
    return found;
  };
  // How high a line of this colour is at x, inside the panel: the first that gets there.
  const height = (svg, panel, colour, x) => {
    const inside = ([px, py]) => px >= panel.x.from - 1 && px <= panel.x.to + 1 && py >= panel.y.to - 1 && py <= panel.y.from + 1;
    for (const line of all(`path.l.${colour}`, svg).flatMap(lines)) {
      for (let i = 1; i < line.length; i += 1) {
        const [a, b] = [line[i - 1], line[i]];
        if (!inside(a) || !inside(b) || (a[0] - x) * (b[0] - x) > 0) continue;
        return a[0] === b[0] ? b[1] : a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
      }
    }
    return null;
  };
  const read = (svg, output, at) => {
    const plot = JSON.parse(svg.dataset.plot);
    const panel = panels(plot).find((p) => at.x >= p.x.from && at.x <= p.x.to && at.y >= p.y.to && at.y <= p.y.from);
    svg.querySelector(".hair")?.remove();
    output.textContent = "";
    if (!panel) return;
    const parts = [`${panel.x.label || "t"}: ${digits(value(panel.x, at.x))}`];
    for (const [colour, name] of plot.names) {
      const y = height(svg, panel, colour, at.x);
      if (y !== null) parts.push(`${name}: ${digits(value(panel.y, y))}`);
    }
    if (parts.length === 1) parts.push(`${panel.y.label}: ${digits(value(panel.y, at.y))}`);
    output.textContent = parts.join("   ·   ");
    const hair = document.createElementNS(SPACE, "line");
    hair.setAttribute("class", "hair");
    for (const [name, v] of [["x1", at.x], ["x2", at.x], ["y1", panel.y.from], ["y2", panel.y.to]]) hair.setAttribute(name, v);
    svg.append(hair);
  };
  all(".drawing").forEach((drawing) => {
    const svg = drawing.querySelector("svg");
    const output = document.createElement("output");
    drawing.append(output);
    drawing.tabIndex = 0;
    let at = null;
    drawing.addEventListener("pointermove", (event) => {
      const map = svg.getScreenCTM();
      if (!map) return;
      at = new DOMPoint(event.clientX, event.clientY).matrixTransform(map.inverse());
      read(svg, output, at);
    });
    drawing.addEventListener("pointerleave", () => { svg.querySelector(".hair")?.remove(); output.textContent = ""; });
    drawing.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: -24, ArrowRight: 24 }[event.key];
      const panel = panels(JSON.parse(svg.dataset.plot))[0];
      if (!step || !panel) return;
      event.preventDefault();
      at ??= { x: 0.5 * (panel.x.from + panel.x.to), y: 0.5 * (panel.y.from + panel.y.to) };
      at = { x: Math.min(panel.x.to, Math.max(panel.x.from, at.x + step)), y: at.y };
      read(svg, output, at);
    });
  });
})();
