// Without this script every picture is seen, one below the other. With it one at a time, chosen by buttons and keys.
'use strict';

const MAPS = [['picture', 'Picture'], ['flip', 'FLIP'], ['difference', 'Difference']];

/** The pictures of one section: which shot, technique (0 is the reference) and map is looked at. */
class Viewer {
  constructor(section) {
    this.section = section;
    this.shots = [...section.querySelectorAll('.shot')];
    this.names = [...this.shots[0].querySelectorAll('.stage img[data-map="picture"]')].map((image) => image.alt);
    this.state = {shot: 0, technique: Math.min(1, this.names.length - 1), map: 0};
    this.last = this.state.technique;
    this.buttons = {};
    const controls = document.createElement('div');
    controls.className = 'controls';
    if (this.shots.length > 1)
      controls.append(this.choices('shot', section.dataset.axis || 'Scene', this.shots.map((shot) => shot.dataset.label)));
    controls.append(this.choices('technique', 'Picture of', this.names));
    controls.append(this.choices('map', 'Shown as', MAPS.map(([, name]) => name)));
    this.shots[0].before(controls);
    this.shots.forEach((shot) => Viewer.addReference(shot));
    section.classList.add('steered');
    this.show({});
  }

  /** In a wide window the reference stands beside what is chosen. */
  static addReference(shot) {
    const stage = shot.querySelector('.stage');
    const beside = document.createElement('figure');
    beside.className = 'beside';
    beside.append(stage.querySelector('img').cloneNode());
    beside.append(Object.assign(document.createElement('figcaption'), {textContent: 'reference'}));
    const panes = document.createElement('div');
    panes.className = 'panes';
    stage.replaceWith(panes);
    panes.append(stage, beside);
  }

  choices(of, title, names) {
    const row = document.createElement('div');
    row.className = 'choices';
    row.setAttribute('role', 'group');
    row.setAttribute('aria-label', title);
    row.append(Object.assign(document.createElement('span'), {textContent: title}));
    this.buttons[of] = names.map((name, index) => {
      const button = Object.assign(document.createElement('button'), {type: 'button', textContent: name});
      button.addEventListener('click', () => this.show({[of]: index}));
      row.append(button);
      return button;
    });
    return row;
  }

  show(change) {
    Object.assign(this.state, change);
    const {shot, technique, map} = this.state;
    if (technique > 0) this.last = technique;
    for (const [of, buttons] of Object.entries(this.buttons))
      buttons.forEach((button, index) => button.setAttribute('aria-pressed', index === this.state[of]));
    this.shots.forEach((article, index) => {
      article.hidden = index !== shot;
      for (const image of article.querySelectorAll('.stage img'))
        // The reference has no map of its own error.
        image.hidden = +image.dataset.technique !== technique ||
            image.dataset.map !== (technique === 0 ? 'picture' : MAPS[map][0]);
      article.querySelectorAll('tbody tr').forEach((row, i) => row.classList.toggle('current', i + 1 === technique));
    });
    current = this;
  }

  step(of, by) {
    const count = this.buttons[of]?.length ?? 1;
    this.show({[of]: (this.state[of] + by + count) % count});
  }

  flip() { this.show({technique: this.state.technique === 0 ? this.last : 0}); }
}

let current = null;
const viewers = [...document.querySelectorAll('section:has(.shot)')].map((section) => new Viewer(section));
for (const viewer of viewers)
  viewer.section.addEventListener('pointerenter', () => { current = viewer; });
current = viewers[0];

// Keys go to the section that was touched last, or else to the one in the middle of the window.
addEventListener('scrollend', () => {
  const middle = innerHeight / 2;
  const seen = viewers.find(({section}) => {
    const {top, bottom} = section.getBoundingClientRect();
    return top <= middle && middle < bottom;
  });
  if (seen) current = seen;
});

const KEYS = {
  r: (viewer) => viewer.flip(),
  ArrowLeft: (viewer) => viewer.step('technique', -1),
  ArrowRight: (viewer) => viewer.step('technique', 1),
  h: (viewer) => viewer.step('map', 1),
  '[': (viewer) => viewer.step('shot', -1),
  ']': (viewer) => viewer.step('shot', 1),
};

addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || !current) return;
  if (/^[0-9]$/.test(event.key) && +event.key < current.names.length) current.show({technique: +event.key});
  else if (KEYS[event.key]) KEYS[event.key](current);
  else return;
  event.preventDefault();
});

const help = document.createElement('p');
help.className = 'note';
help.innerHTML = '<kbd>R</kbd> reference and back · <kbd>←</kbd> <kbd>→</kbd> or <kbd>0</kbd>–<kbd>9</kbd> techniques · ' +
    '<kbd>H</kbd> heat maps · <kbd>[</kbd> <kbd>]</kbd> scenes and values';
document.querySelector('header').append(help);
