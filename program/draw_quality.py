#!/usr/bin/env python3
"""Draws the smallest dihedral angles of the tetrahedra before and after the improvement, from a report of mesh_surface.

usage: draw_quality.py REPORT.json CHART.svg

Only Python's standard library is used.
"""
import json
import sys
from xml.sax.saxutils import escape

DEGREES_PER_BIN = 5
LEFT, TOP, WIDTH, HEIGHT, RIGHT, BOTTOM = 60, 60, 640, 280, 20, 100  # of the diagram, and the space around it
COLORS = {'before': '#b8b8b8', 'after': '#2266aa'}
REASONS = (('forced', 'forced by the surface'), ('gap', 'in gaps of it'), ('needle', 'at needles of it'), ('not_improved', 'not improved'))


def shares(figures):
    """The percentage of the tetrahedra in each bin."""
    histogram = figures['histogram_of_smallest_angles']
    return [100 * n / max(1, sum(histogram)) for n in histogram]


def ceiling(x):
    """The smallest number at least as large as x that is 1, 2 or 5 times a power of ten, and the number of its parts."""
    unit = 1e-6
    while True:
        for factor, parts in ((1, 5), (2, 4), (5, 5)):
            if x <= factor * unit:
                return factor * unit, parts
        unit *= 10


def text(x, y, words, anchor='middle', size=12, color='black'):
    return ('<text x="%.1f" y="%.1f" text-anchor="%s" font-size="%d" fill="%s">%s</text>'
            % (x, y, anchor, size, color, escape(words)))


def rectangle(x, y, width, height, color, title=''):
    return ('<rect x="%.2f" y="%.2f" width="%.2f" height="%.2f" fill="%s"><title>%s</title></rect>'
            % (x, y, width, height, color, escape(title)))


def line(x1, y1, x2, y2, color, dashes=''):
    return ('<line x1="%.1f" y1="%.1f" x2="%.1f" y2="%.1f" stroke="%s"%s/>'
            % (x1, y1, x2, y2, color, dashes and ' stroke-dasharray="%s"' % dashes))


def summary(name, figures):
    angles = [figures[key] for key in ('min_dihedral_angle', 'max_dihedral_angle')]
    return '%s: %d tetrahedra, dihedral angles from %.3g to %.4g degrees' % (name, figures['number_of_tetrahedra'], *angles)


def chart(report):
    """The lines of the drawing."""
    improvement = report['improvement']
    bars = {name: shares(improvement[name]) for name in COLORS}
    bins = max((i + 1 for values in bars.values() for i, x in enumerate(values) if x > 0), default=1)
    bins = max(bins, int(improvement['target_angle'] // DEGREES_PER_BIN) + 1)
    highest, parts = ceiling(max(max(values) for values in bars.values()))
    width, bottom = WIDTH / bins, TOP + HEIGHT
    lines = [text(LEFT + WIDTH / 2, 24, 'Smallest dihedral angle of each tetrahedron', size=16),
             text(LEFT + WIDTH / 2, 44, report['input'], color='#555555')]
    for i in range(parts + 1):
        y = bottom - HEIGHT * i / parts
        lines += [line(LEFT, y, LEFT + WIDTH, y, '#dddddd'), text(LEFT - 6, y + 4, '%g %%' % (highest * i / parts), 'end')]
    for k, (name, color) in enumerate(COLORS.items()):
        for i, share in enumerate(bars[name][:bins]):
            height = HEIGHT * share / highest
            title = '%s, %d to %d degrees: %d tetrahedra' % (
                name, DEGREES_PER_BIN * i, DEGREES_PER_BIN * (i + 1), improvement[name]['histogram_of_smallest_angles'][i])
            lines.append(rectangle(LEFT + width * (i + 0.1 + 0.4 * k), bottom - height, 0.4 * width, height, color, title))
    for i in range(bins + 1):
        lines.append(text(LEFT + width * i, bottom + 16, '%d' % (DEGREES_PER_BIN * i)))
    x = LEFT + width * improvement['target_angle'] / DEGREES_PER_BIN
    lines += [line(LEFT, bottom, LEFT + WIDTH, bottom, 'black'), line(x, TOP, x, bottom, '#cc3333', '4 3'),
              text(x + 4, TOP + 12, 'target', 'start', color='#cc3333')]
    for k, (name, color) in enumerate(COLORS.items()):
        y = bottom + 36 + 18 * k
        lines += [rectangle(LEFT, y - 10, 12, 12, color), text(LEFT + 20, y, summary(name, improvement[name]), 'start')]
    counts = ', '.join('%d %s' % (improvement['number_of_' + reason], words) for reason, words in REASONS)
    lines.append(text(LEFT + 20, bottom + 72, 'below the target: ' + counts, 'start'))
    return lines


def svg(report):
    width, height = LEFT + WIDTH + RIGHT, TOP + HEIGHT + BOTTOM
    begin = ('<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" viewBox="0 0 %d %d" font-family="sans-serif">'
             % (width, height, width, height))
    return '\n'.join([begin, rectangle(0, 0, width, height, 'white')] + chart(report) + ['</svg>', ''])


def main(arguments):
    if len(arguments) != 2 or arguments[0] in ('-h', '--help'):
        print(__doc__.strip(), file=sys.stderr)
        return 1
    try:
        with open(arguments[0], encoding='utf-8') as file:
            report = json.load(file)
        if 'improvement' not in report:
            raise ValueError('the report tells of no improvement')
        with open(arguments[1], 'w', encoding='utf-8') as file:
            file.write(svg(report))
    except (OSError, ValueError) as error:
        print('draw_quality.py: %s: %s' % (arguments[0], error), file=sys.stderr)
        return 1
    return 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
