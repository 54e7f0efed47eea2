// Keys, and the list of them that Help shows.
const click = (id) => () => document.getElementById(id).click();

export const KEYS = [
    { keys: [' '], shown: ['Space'], words: 'Wind the strip, or pause', id: 'play' },
    { keys: [',', '.'], shown: [',', '.'], words: 'One cell back or on (with Shift: a hundredth)' },
    { keys: ['0'], shown: ['0'], words: 'All wound, or nothing' },
    { keys: ['c'], shown: ['C'], words: 'Curve through the cells', id: 'curve' },
    { keys: ['l'], shown: ['L'], words: 'Links', id: 'links' },
    { keys: ['u'], shown: ['U'], words: 'The unwound part', id: 'rest' },
    { keys: ['e'], shown: ['E'], words: 'Edges', id: 'edges' },
    { keys: ['s'], shown: ['S'], words: 'Flat or smooth' },
    { keys: ['t'], shown: ['T'], words: 'Y or Z upwards' },
    { keys: ['n'], shown: ['N'], words: 'Colour by the next thing' },
    { keys: ['k'], shown: ['K'], words: 'Cut tets', id: 'clip', tets: true },
    { keys: ['x', 'y', 'z'], shown: ['X', 'Y', 'Z'], words: 'Direction of the cut', tets: true },
    { keys: ['v'], shown: ['V'], words: 'Cut from the other side', id: 'flip', tets: true },
    { keys: ['[', ']'], shown: ['[', ']'], words: 'Move the cut', tets: true },
    { keys: ['b'], shown: ['B'], words: 'Shrink cells, step by step', tets: true },
    { keys: ['f'], shown: ['F'], words: 'Show all of the mesh' },
    { keys: ['o'], shown: ['O'], words: 'Open a file', id: 'open' },
    { keys: ['?'], shown: ['?'], words: 'This list', id: 'help' },
];

export function fill_help(list) {
    for (const { shown, words } of KEYS) {
        const term = document.createElement('dt'), meaning = document.createElement('dd');
        shown.forEach((key, i) => {
            const cap = document.createElement('kbd');
            cap.textContent = key;
            term.append(i ? ' ' : '', cap);
        });
        meaning.textContent = words;
        list.append(term, meaning);
    }
}

// `actions[key](event)` for keys that are more than a click.
export function watch_keys(actions, has_tets) {
    addEventListener('keydown', (event) => {
        if (event.ctrlKey || event.metaKey || event.altKey || document.querySelector('dialog[open]')) return;
        const target = event.target, typing = target.matches?.('select, input[type=text]');
        // Space and arrows belong to the control that has the focus.
        if (typing || (event.key === ' ' && target.matches?.('button, input'))) return;
        const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
        const entry = KEYS.find(({ keys }) => keys.includes(key) || keys.includes({ '<': ',', '>': '.' }[key]));
        if (entry === undefined || (entry.tets && !has_tets())) return;
        event.preventDefault();
        (actions[key] ?? actions[{ '<': ',', '>': '.' }[key]] ?? click(entry.id))(event);
    });
}
