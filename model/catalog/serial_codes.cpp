#include "serial_codes.h"

#include "catalog.h"

#include <algorithm>
#include <QByteArrayView>

namespace lds::catalog {

namespace {

std::span<const Choice> choicesOf(ItemId item) { return hlG2(item).choices; }

/// The catalog names a speed by its number, "38400 bps", and a parity by a word, "EVEN + 1bit".
QByteArrayView firstWord(const Choice& choice)
{
    const QByteArrayView name(choice.name);
    return name.first(std::max<qsizetype>(0, name.indexOf(' ')));
}

int speedOf(const Choice& choice) { return firstWord(choice).toInt(); }

LineParity parityOf(const Choice& choice)
{
    const QByteArrayView word = firstWord(choice);
    return word == "EVEN" ? LineParity::Even : word == "ODD" ? LineParity::Odd : LineParity::None;
}

template <typename Meaning, typename Translate>
std::optional<Meaning> meaningOf(ItemId item, Value code, const Translate& translate)
{
    const auto choices = choicesOf(item);
    const auto found = std::ranges::find(choices, code, &Choice::code);
    return found == choices.end() ? std::nullopt : std::optional<Meaning>(translate(*found));
}

} // namespace

std::optional<int> lineSpeed(Value code) { return meaningOf<int>(ItemId::CommunicationSpeed, code, speedOf); }

std::optional<Value> lineSpeedCode(int bitsPerSecond)
{
    const auto choices = choicesOf(ItemId::CommunicationSpeed);
    const auto found = std::ranges::find(choices, bitsPerSecond, speedOf);
    return found == choices.end() ? std::nullopt : std::optional(found->code);
}

std::optional<LineParity> lineParity(Value code)
{
    return meaningOf<LineParity>(ItemId::ParityStopBit, code, parityOf);
}

Value lineParityCode(LineParity parity)
{
    const auto choices = choicesOf(ItemId::ParityStopBit);
    const auto found = std::ranges::find(choices, parity, parityOf);
    return found == choices.end() ? 0 : found->code;
}

} // namespace lds::catalog
