# The names, titles and styles of the formulations, and a palette, of figures/style.gp, for the pages that compute.
1i const title = {}, line = {};
s/^names = (".*")$/const listed = \1.split(" ");/p
s/^title_(\w+) *= (".*")$/title.\1 = \2;/p
s/^set style line ([0-9]+) linecolor rgb ("#......") dashtype (1|\(([0-9,]+)\)) +pointtype ([0-9]+) +pointsize [0-9.]+ linewidth ([0-9.]+).*/line[\1] = { color: \2, dash: "\4", point: \5, width: \6 };/p
/^sequential = /{
s/.*\((.*)\).*/\1/
s/'/"/g
s/([0-9.]+) ("#......"),?/[\1, \2],/g
s/.*/const sequential = [&];/p
}
$a const styles = Object.fromEntries(listed.map((name, k) => [name, { title: title[name], ...line[k + 1] }]));
