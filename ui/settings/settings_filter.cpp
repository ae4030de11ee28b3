#include "settings_filter.h"

#include "settings_model.h"

#include <algorithm>

namespace lds::ui {

namespace {

/// For the comparison with the model's search text.
QString normalized(const QString& text)
{
    // NFKC makes the full-width letters and digits of an East Asian keyboard plain.
    return text.normalized(QString::NormalizationForm_KC).toLower().replace(QChar(0x2212), u'-');
}

} // namespace

SettingsFilter::SettingsFilter(SettingsModel& model, QObject* parent)
    : QSortFilterProxyModel(parent)
    , m_model(model)
{
    setSourceModel(&model);
    setRecursiveFilteringEnabled(true);
}

void SettingsFilter::setText(const QString& text)
{
    if (text == m_text)
        return;
    m_text = text;
    m_words = normalized(text).split(u' ', Qt::SkipEmptyParts);
    invalidateFilter();
}

void SettingsFilter::setChangedOnly(bool changedOnly)
{
    if (changedOnly == m_changedOnly)
        return;
    m_changedOnly = changedOnly;
    invalidateFilter();
}

void SettingsFilter::setPinned(const QModelIndex& sourceIndex)
{
    if (m_pinned == sourceIndex)
        return;
    m_pinned = sourceIndex;
    if (isActive())
        invalidateFilter();
}

bool SettingsFilter::filterAcceptsRow(int sourceRow, const QModelIndex& sourceParent) const
{
    const QModelIndex index = m_model.index(sourceRow, SettingsModel::Menu, sourceParent);
    if (m_pinned.isValid() && index == m_pinned.sibling(m_pinned.row(), SettingsModel::Menu))
        return true;
    const SettingRow* row = m_model.row(index);
    if (!row)
        return false;
    if (m_changedOnly) {
        const auto changed = SettingsModel::Edited | SettingsModel::WrongText;
        if (row->isHeading() || !(m_model.states(*row) & changed))
            return false;
    }
    return matches(*row);
}

bool SettingsFilter::beginsMenuNumber(const QString& word) const
{
    if (!m_model.tree())
        return false;
    const auto& rows = m_model.tree()->all();
    return std::any_of(rows.begin(), rows.end(), [&word](const SettingRow* row) {
        return row->menu && QString::number(row->menu).startsWith(word);
    });
}

bool SettingsFilter::matches(const SettingRow& row) const
{
    return std::all_of(m_words.begin(), m_words.end(), [this, &row](const QString& word) {
        // What a heading is found by finds all that stands under it.
        for (const SettingRow* each = &row; each; each = each->parent) {
            if (wordMatches(*each, word))
                return true;
        }
        return false;
    });
}

bool SettingsFilter::wordMatches(const SettingRow& row, const QString& word) const
{
    if (!beginsMenuNumber(word))
        return m_model.searchText(row).contains(word);
    if (row.menu && QString::number(row.menu).startsWith(word))
        return true;
    // "22" is menu 22 and a value of 22, not every address and help text with two twos in it.
    return m_model.valueTexts(row).contains(word);
}

} // namespace lds::ui
