# Help and version go to stdout with exit code 0, and every verb has examples or a word of advice.
ravel --version
for verb in "" encode decode info verify strip compare make view; do
    ravel $verb --help >help || echo "help of '$verb' failed"
    [ "$(wc -l <help)" -ge 5 ] || echo "help of '$verb' is short"
done
ravel --help | grep -c '^  \(encode\|decode\|info\|verify\|strip\|compare\|make\|view\) '
for verb in encode decode verify strip compare make view; do
    ravel $verb --help | grep -q '^Example' || echo "$verb has no examples"
done
